# Parts of all studies: variables that users set, tables, claims and pages. runs.mk has specimens and runs.
#
# A study sets `runs`, the files of the runs that it needs, by $(call run,TEST,SIZE,SEED,SETTINGS,LABELS), and includes this file. Its
# tables are in $(OUT)/STUDY. Runs are in $(OUT)/runs/ROCK, where ROCK is the material with four digits that change with its values;
# studies share them. Users set:
#
#     make SEEDS="1 2"         other seeds               make EDGE=4mm        another grain size
#     make MATERIAL=my.toml    another rock              make OUT=/scratch    where results go
#     make -j 2                runs side by side         make THREADS=2       threads of a run
#     make RANKS=4             ranks of a run (MPI)      make MPIRUN="srun …" what starts them, with -n RANKS behind it
#     make LAUNCH="srun …"     command before a run      make MAX_STRAIN=0.01 strain limit of runs without a peak
#     make GF=90               fracture energy, J/m²     make OPEN=7.7        shear strength of open contacts, MPa
#     make LAW=literal         another contact law       make UNIAXIAL_PEAK_DROP=0.3   uniaxial runs to a larger drop below the peak;
#                                                                                      none: to the strain limit
#     make CONFINED= UNIAXIAL=                           runs with the solver's default loading rate, or another tolerance of it
#     make -n                  print what would be done  make clean           remove tables and pages; distclean: runs too
#
# A run or table appears complete or not at all. A failing run stops the study with the run's own message.
SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
export LC_ALL := C
.DELETE_ON_ERROR:
.SECONDEXPANSION:
.DEFAULT_GOAL = all

# --- places ----------------------------------------------------------------------------------------------------------

STUDIES := $(patsubst %/,%,$(dir $(abspath $(lastword $(MAKEFILE_LIST)))))
STUDY ?= $(notdir $(CURDIR))
# The tools: those of the build, of the installation that this is a part of, or on the PATH.
solvers := $(wildcard $(STUDIES)/../../build/bin/graincrack-solve $(STUDIES)/../../../bin/graincrack-solve) \
           $(shell command -v graincrack-solve)
BIN ?= $(patsubst %/,%,$(dir $(abspath $(firstword $(solvers)))))
MESH = $(BIN)/graincrack-mesh
POST = $(BIN)/graincrack-post
include $(STUDIES)/lib/places.mk
HERE := $(OUT)/$(STUDY)

# Variables that users set must be variables of some study: a misspelt one would change nothing.
assignment := ^\(override \)\{0,1\}\([A-Za-z_-][A-Za-z_0-9-]*\) *[?:+]\{0,1\}=.*
variables_of_studies := WANTED TABLE \
    $(shell sed -n 's/$(assignment)/\2/p' $(STUDIES)/*.mk $(STUDIES)/*/*.mk $(STUDIES)/*/Makefile)
set_by_user = $(filter command,$(firstword $(origin $(1))))
user_variables := $(foreach v,$(filter-out -* .% MAKE% GRAINCRACK_% options_%,$(.VARIABLES)),$(if $(call set_by_user,$(v)),$(v)))
$(foreach v,$(filter-out $(variables_of_studies),$(user_variables)),$(error $(v)=$($(v)): no study reads $(v); \
    share/studies/common.mk and the head of its Makefile have the variables of a study))

# --- the rock --------------------------------------------------------------------------------------------------------

MATERIAL ?= augig-granite
materials = $(filter /%,$(MATERIAL)) $(CALLED_FROM)/$(MATERIAL) $(STUDIES)/../materials/$(MATERIAL).toml
MATERIAL_FILE := $(abspath $(firstword $(wildcard $(materials))))
$(if $(MATERIAL_FILE),,$(error $(or $(material_variable),MATERIAL)=$(MATERIAL): no such file, nor a name in share/materials))
# Its name with a checksum of the values that runs depend on: the laboratory's too where they stand for [rock].
has_rock := $(shell awk '/^\[/ { on = /^\[rock\]/ } on && /^tensile_strength/' $(MATERIAL_FILE))
values := awk '/^\[/ { on = $$0 !~ /^\[($(if $(has_rock),laboratory|)targets|parameters|study|fitted)[].]/ } on && NF'
MATERIAL_ID := $(basename $(notdir $(MATERIAL_FILE))).$(shell sed -e 's/\#.*//' -e 's/[[:space:]]*$$//' $(MATERIAL_FILE) | \
    $(values) | cksum | awk '{ printf "%04x", $$1 % 65536 }')
# $(call of_material,contact.cohesion): a value as a bare number, in MPa, degrees, mm
of_material = $(shell $(POST) material value $(1) $(MATERIAL_FILE))
# $(call point_of_material): its own contact strengths, as a setting. $(call point_of_material,TC): with another tensile strength
tensile_strength = $(or $(1),$(call of_material,contact.tensile_strength))
point_of_material = $(call at_point,$(tensile_strength),$(call of_material,contact.cohesion),$(call of_material,contact.friction_angle))

# --- lists and texts -------------------------------------------------------------------------------------------------

comma := ,
empty :=
space := $(empty) $(empty)
tab := $(shell printf '\t')
define newline


endef
# $(call times,SHARES,VALUE): numbers
times = $(shell awk 'BEGIN { n = split("$(1)", s, " "); for (i = 1; i <= n; ++i) printf "%s%.6g", (i > 1 ? " " : ""), s[i] * $(2) }')
# $(call unique,LIST): without repetitions, in its order
unique = $(if $(1),$(firstword $(1)) $(call unique,$(filter-out $(firstword $(1)),$(1))))
# $(call same,TEXT,TEXT), but for white space: GNU make 4.3 sometimes leaves the last line end of a file that it reads.
same = $(call equal,x$(strip $(1))x,x$(strip $(2))x)
equal = $(and $(findstring $(1),$(2)),$(findstring $(2),$(1)))
# Text as one word of a list: ~ stands for a space, | is between the columns of a row.
word_of = $(subst $(space),~,$(strip $(1)))
# $(call rows_of,FILE): the rows of a table as words, with | before each column. $(call column_of,NUMBER,ROW): an entry of such a row
rows_of = $(foreach r,$(shell tail -n +2 $(1) | tr ' \t' '~|'),|$(r))
column_of = $(subst ~, ,$(patsubst |%,%,$(word $(1),$(subst |, |,$(2)))))
# FORCE is never up to date: $(if CONDITION,,FORCE) among the prerequisites makes a file anew.
FORCE:

include $(STUDIES)/runs.mk

# --- tables ----------------------------------------------------------------------------------------------------------

# Recipes for tables: $(call table,COMMAND) writes $@ completely or not at all.
define table
@mkdir -p $(@D)
@$(1) >$@.part && mv $@.part $@
endef
# The runs among the prerequisites, relative to $(RUNS), which keeps tables narrow and command lines short.
run_files = $(patsubst $(RUNS)/%,%,$(filter $(RUNS)/%,$^))
# $(call of_runs,SUBCOMMAND): the postprocessor on these runs
of_runs = cd $(RUNS) && $(POST) --quiet $(1) $(run_files)
# The last rows of the histories of these runs, with the file before each.
last_rows = { cd $(RUNS) && for run in $(run_files); do \
    $(POST) --quiet history $$run | sed -n -e '1s/^/file\t/p' -e "\$$s/^/$$run\t/p"; done | awk '!/^file/ || !n++'; }
# Tables that depend on runs depend on these too: with other SEEDS or laboratory values they are made anew, though no run is.
runs_list = $(HERE)/runs.tsv $(HERE)/material.toml
$(HERE)/material.toml: $$(if $$(call same,$$(file <$$@),$$(file <$$(MATERIAL_FILE))),,FORCE)
	@mkdir -p $(@D) && cp $(MATERIAL_FILE) $@
# The query among the prerequisites, *.sql, of the tables among them.
query = $(POST) summarize $(filter %.tsv,$^) --sql $(filter %.sql,$^)
# Verdicts on the claims of a study: its criteria.tsv, judged by the numbers of measured.tsv, which its measured.sql makes of its tables.
ifneq ($(wildcard criteria.tsv),)
judged := $(STUDIES)/lib/judged.sql $(STUDIES)/lib/measured.tsv
$(HERE)/claims.tsv: criteria.tsv $(HERE)/measured.tsv $(judged)
	$(call table,$(POST) summarize $< $(patsubst %,measured=%,$(filter %/measured.tsv,$^)) --sql $(firstword $(judged)) --set STUDY=$(STUDY))
endif

# --- the page --------------------------------------------------------------------------------------------------------

# As Markdown: a text of the study, its claims, tables and pictures in the order of the prerequisites, then quality checks.
page = $(call table,$(STUDIES)/lib/page $(POST) $(filter-out $(RUNS)/% $(checks),$^) $(filter $(checks),$^))
checks = $(HERE)/checks.tsv
$(HERE)/page.md: $$(if $$(strip $$(runs)),$(checks))
$(checks): $$(runs) $(runs_list)
	$(call table,($(call of_runs,strength --all-columns)) | $(POST) summarize strength=- --sql $(STUDIES)/lib/checks.sql)

.PHONY: all clean distclean print-runs print-here
# For job-array: the files of the runs, a line each, and the folder of the study.
print-runs:
	@$(if $(runs),printf '%s\n' $(runs))
print-here:
	@echo $(HERE)
clean:
	rm -rf -- $(HERE)
distclean: clean
	@cd $(OUT) 2>/dev/null && rm -f -- $(patsubst $(OUT)/%,%,$(runs) $(runs:=.options) $(runs:=.checkpoint)) || true
