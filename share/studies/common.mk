# What the studies have in common: specimens and runs by rules, tables by the postprocessor. A study includes this file after it
# has set what it wants otherwise, and names its runs $(OUT)/TEST-SEED-VARIANT.h5.
#
#     TESTS      names of tests; test_NAME holds the subcommand and its options, shape_NAME the specimen
#     SEEDS      seeds of the specimens; every variant runs on the same ones
#     VARIANTS   names of variants; options_NAME holds their options
#
# Users set:
#
#     make SEEDS="1 2"         other seeds             make EDGE=4mm        another grain size
#     make THREADS=2           threads of a run        make LAUNCH="srun"   what to start runs with
#     make OUT=/scratch/here   where results go        make -j 2            runs side by side
#
# A run appears whole or not at all, and is never repeated while it is newer than its specimen. A failing run stops the study with
# the run's own message.
SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:

BIN ?= $(abspath $(dir $(lastword $(MAKEFILE_LIST)))../../build/bin)
OUT ?= results
SEEDS ?= 1 2 3
THREADS ?= 1
MATERIAL ?= augig-granite
LAUNCH ?=
# Defaults of the runs, which options of a variant win over.
export GRAINCRACK_MASS_SCALING ?= selective
OPTIONS ?=

RECTANGLE ?= --width 80mm --height 160mm $(if $(EDGE),--edge $(EDGE),--grains 1122)
DISC ?= --diameter 80mm $(if $(EDGE),--edge $(EDGE),--grains 452)
test_brazilian ?= brazilian
shape_brazilian ?= disc
test_uniaxial ?= uniaxial
shape_uniaxial ?= rectangle
test_tension ?= tension
shape_tension ?= rectangle
test_triaxial4 ?= triaxial --confining-pressure 4MPa
shape_triaxial4 ?= rectangle
test_triaxial8 ?= triaxial --confining-pressure 8MPa
shape_triaxial8 ?= rectangle

MESH = $(BIN)/graincrack-mesh
SOLVE = $(LAUNCH) $(BIN)/graincrack-solve
POST = $(BIN)/graincrack-post

$(OUT):
	@mkdir -p $@
$(OUT)/disc-%.h5: | $(OUT)
	@$(MESH) disc $(DISC) --seed $* --quiet -o $@
$(OUT)/rectangle-%.h5: | $(OUT)
	@$(MESH) rectangle $(RECTANGLE) --seed $* --quiet -o $@

# $(call run_rule,test,seed,variant)
define run_rule
$(OUT)/$(1)-$(2)-$(3).h5: $(OUT)/$(shape_$(1))-$(2).h5
	@echo "$(1), seed $(2), $(3)"
	@$$(SOLVE) $(word 1,$(test_$(1))) $$< $(wordlist 2,99,$(test_$(1))) --material $$(MATERIAL) --threads $$(THREADS) --quiet $$(OPTIONS) $$(options_$(3)) -o $$@
endef
# $(call runs,tests,seeds,variants): their files
runs = $(foreach t,$(1),$(foreach v,$(3),$(foreach s,$(2),$(OUT)/$(t)-$(s)-$(v).h5)))
# To be evaluated once tests and variants are known: $(eval $(run_rules))
run_rules = $(foreach t,$(TESTS),$(foreach s,$(SEEDS),$(foreach v,$(VARIANTS),$(eval $(call run_rule,$(t),$(s),$(v))))))

.PHONY: clean
clean:
	rm -rf -- $(OUT)
