# Makes the runs WANTED, names without what variables of this make add, and adds their measures to the tables of the calibration.
include ../common.mk
test_of = $(firstword $(subst _, ,$(1)))
with_variables = $(1)$(user_tokens)$(and $(filter uniaxial,$(call test_of,$(1))),$(UNIAXIAL_PEAK_DROP:%=_drop%))$(call rate_tokens,$(call test_of,$(1)))
runs := $(foreach w,$(WANTED),$(RUNS)/$(call with_variables,$(w)).h5)
notched := $(strip $(foreach r,$(runs),$(if $(findstring n,$(lastword $(subst x, ,$(word 2,$(call words_of,$(r)))))),$(r))))
uniaxial := $(filter $(RUNS)/uniaxial_%,$(runs))
.DEFAULT_GOAL = measured
# $(call add,COMMAND,RUNS): adds rows to a table, or makes it; complete or not at all. A run's name has its folder, which is its material:
# runs of grains with other E and ν are called the same but for it.
define add
@$(if $(2),cd $(OUT)/runs && $(POST) --quiet $(1) $(patsubst $(OUT)/runs/%,%,$(2)) >$(HERE)/new.part && { cat $(HERE)/$(1).tsv 2>/dev/null && tail -n +2 $(HERE)/new.part || cat $(HERE)/new.part; } >$(HERE)/$(1).part && mv $(HERE)/$(1).part $(HERE)/$(1).tsv && rm $(HERE)/new.part,:)
endef
# `strength` comes last: a run is finished when it has a row there.
.PHONY: measured
measured: $(runs)
	$(call add,moduli,$(uniaxial))
	$(call add,toughness,$(notched))
	$(call add,strength,$(runs))
