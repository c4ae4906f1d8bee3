# Makes the runs of the table WANTED, whose options are complete, and adds their measures to the tables of the calibration.
include ../common.mk
added :=
entry = $(call column_of,$(1),$(r))
runs := $(foreach r,$(call rows_of,$(WANTED)),$(call \
    note,$(patsubst %.h5,%,$(call entry,1)),$(call entry,2),$(call entry,3),$(call entry,4),$(call entry,5)))
.DEFAULT_GOAL = measured
# $(call add,COMMAND,RUNS): adds rows to a table, or makes it; complete or not at all. Names of runs come from a file, as there are many.
define add
@$(if $(2),$(file >$(HERE)/$(1).list,$(subst $(space),$(newline),$(strip $(2:$(RUNS)/%=%)))) \
    cd $(RUNS) && $(POST) --quiet $(1) $(if $(filter-out toughness,$(1)),--all-columns) --files-from $(HERE)/$(1).list >$(HERE)/new.part && \
    { cat $(HERE)/$(1).tsv 2>/dev/null && tail -n +2 $(HERE)/new.part || cat $(HERE)/new.part; } >$(HERE)/$(1).part && \
    mv $(HERE)/$(1).part $(HERE)/$(1).tsv && rm $(HERE)/new.part $(HERE)/$(1).list,:)
endef
# `strength` comes last: a run is finished when it has a row there.
.PHONY: measured
measured: $(runs)
	$(call add,moduli,$(call of_test,uniaxial triaxial,$(runs)))
	$(call add,toughness,$(call of_test,bend,$(runs)))
	$(call add,strength,$(runs))
