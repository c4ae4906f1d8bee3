# Makes the runs of the table WANTED, with what variables of this make add, and adds their measures to the tables of the calibration.
include ../common.mk
run_of_row = $(call note,$(patsubst %.h5,%,$(call column_of,1,$(1))),$(call column_of,2,$(1)),$(call column_of,3,$(1)),$(call column_of,4,$(1)),$(call column_of,5,$(1)))
runs := $(foreach r,$(call rows_of,$(WANTED)),$(call run_of_row,$(r)))
notched := $(strip $(foreach r,$(runs),$(if $(findstring --notch,$(mesh_$(specimen_$(r)))),$(r))))
.DEFAULT_GOAL = measured
# $(call add,COMMAND,RUNS): adds rows to a table, or makes it; complete or not at all. A run's name has its folder, which is its material.
define add
@$(if $(2),cd $(OUT)/runs && $(POST) --quiet $(1) $(patsubst $(OUT)/runs/%,%,$(2)) >$(HERE)/new.part && { cat $(HERE)/$(1).tsv 2>/dev/null && tail -n +2 $(HERE)/new.part || cat $(HERE)/new.part; } >$(HERE)/$(1).part && mv $(HERE)/$(1).part $(HERE)/$(1).tsv && rm $(HERE)/new.part,:)
endef
# `strength` comes last: a run is finished when it has a row there.
.PHONY: measured
measured: $(runs)
	$(call add,moduli,$(call of_test,uniaxial,$(runs)))
	$(call add,toughness,$(notched))
	$(call add,strength,$(runs))
