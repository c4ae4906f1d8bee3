# Rules and variables that all studies share: specimens, runs, tables and pages.
#
# A run is a row of a table: the name of its file, the name of its specimen, and the options of three tools as they would be typed,
#
#     file      uniaxial_rectangle80x160g1122-s2_tc18_cc122_phic53.h5
#     specimen  rectangle80x160g1122-s2
#     mesh      rectangle --width 80mm --height 160mm --grains 1122 --seed 2             of graincrack-mesh
#     material  --set phases.contrast=0.75                                               of graincrack-post material with; empty: the rock
#     solve     uniaxial --contact-tensile-strength 18MPa --contact-cohesion 122MPa …    of graincrack-solve
#
# and, behind them, what the study calls it by (`label_columns`): tables of results are joined with it by `--look-up`. Names are for readers and say
# what is special in a run, so that studies that need the same run share it and it is made once; nothing reads them. A run whose options
# have changed is made again: FILE.options has those that it was made with.
#
# A study sets `runs`, the files of the runs that it needs, by $(call run,TEST,SIZE,SEED,SETTINGS,LABELS), and includes this file; its table is
# $(OUT)/STUDY/runs.tsv. Runs are in $(OUT)/runs/ROCK, where ROCK is the material with four digits that change with its values. Users set:
#
#     make SEEDS="1 2"         other seeds               make EDGE=4mm        another grain size
#     make MATERIAL=my.toml    another rock              make OUT=/scratch    where results go
#     make -j 2                runs side by side         make THREADS=2       threads of a run
#     make LAUNCH="srun …"     command before a run      make MAX_STRAIN=0.01 strain limit of runs without a peak
#     make GF=90               fracture energy, J/m²     make OPEN=7.7        shear strength of open contacts, MPa
#     make LAW=scaled          another contact law       make UNIAXIAL_PEAK_DROP=0.3   uniaxial runs to a larger drop below the peak; none: to the strain limit
#     make CONFINED= UNIAXIAL=                           runs with the solver's default loading rate, or another tolerance of it
#     make -n                  print what would be done  make clean           remove tables and pages; distclean: runs too
#
# Runs start in the order of `runs`: a study lists the longest first, so that processors finish at about the same time.
#
# A run or table appears complete or not at all. A failing run stops the study with the run's own message.
SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
export LC_ALL := C
.DELETE_ON_ERROR:
.SECONDEXPANSION:
.DEFAULT_GOAL = all

STUDIES := $(patsubst %/,%,$(dir $(abspath $(lastword $(MAKEFILE_LIST)))))
STUDY ?= $(notdir $(CURDIR))
# Variables that users set must be variables of some study: a misspelt one would change nothing.
variables_of_studies := $(shell sed -n 's/^\(override \)\{0,1\}\([A-Za-z_-][A-Za-z_0-9-]*\) *[?:+]\{0,1\}=.*/\2/p' $(STUDIES)/common.mk $(STUDIES)/*/*.mk $(STUDIES)/*/Makefile) WANTED TABLE
user_variables := $(foreach v,$(filter-out -* .% MAKE% GRAINCRACK_% options_%,$(.VARIABLES)),$(if $(filter command,$(firstword $(origin $(v)))),$(v)))
$(foreach v,$(filter-out $(variables_of_studies),$(user_variables)),$(error $(v)=$($(v)): no study reads $(v); share/studies/common.mk and the head of its Makefile have the variables of a study))
# The tools: those of the build, of the installation that this is a part of, or on the PATH.
BIN ?= $(patsubst %/,%,$(dir $(abspath $(firstword $(wildcard $(STUDIES)/../../build/bin/graincrack-solve $(STUDIES)/../../../bin/graincrack-solve) $(shell command -v graincrack-solve)))))
OUT ?= $(STUDIES)/results
# A relative path is relative to where make was called first.
export CALLED_FROM ?= $(PWD)
override OUT := $(abspath $(if $(filter /%,$(OUT)),,$(CALLED_FROM)/)$(OUT))
HERE := $(OUT)/$(STUDY)
SPECIMENS := $(OUT)/specimens
# Intermediate files are kept.
.PRECIOUS: $(SPECIMENS)/%.h5

# --- the rock --------------------------------------------------------------------------------------------------------

MATERIAL ?= augig-granite
MATERIAL_FILE := $(abspath $(firstword $(wildcard $(filter /%,$(MATERIAL)) $(CALLED_FROM)/$(MATERIAL) $(STUDIES)/../materials/$(MATERIAL).toml)))
$(if $(MATERIAL_FILE),,$(error $(or $(material_variable),MATERIAL)=$(MATERIAL): no such file, nor a name in share/materials))
MATERIAL_ID := $(basename $(notdir $(MATERIAL_FILE))).$(shell sed -e 's/\#.*//' -e 's/[[:space:]]*$$//' $(MATERIAL_FILE) | \
                 awk '/^\[/ { on = $$0 !~ /^\[(laboratory|targets|parameters|study|fitted)[].]/ } on && NF' | cksum | awk '{ printf "%04x", $$1 % 65536 }')
RUNS := $(OUT)/runs/$(MATERIAL_ID)
# $(call of_material,contact.cohesion): a value as a bare number, in MPa, degrees, mm
of_material = $(shell $(POST) material value $(1) $(MATERIAL_FILE))
# $(call point_of_material): its own contact strengths, as a setting. $(call point_of_material,TC): with another tensile strength
point_of_material = $(call at_point,$(or $(1),$(call of_material,contact.tensile_strength)),$(call of_material,contact.cohesion),$(call \
    of_material,contact.friction_angle))

# --- the size of things ----------------------------------------------------------------------------------------------

SEEDS ?= 1 2 3 4 5
$(foreach s,$(SEEDS),$(if $(shell printf '%s' '$(s)' | tr -d 0-9),$(error SEEDS=$(SEEDS): $(s) is no whole number; SEEDS="1 2 3" fits)))
# The paper's: 80 mm x 160 mm, 1,122 grains; disc of 80 mm, 452 grains.
WIDTH ?= 80
HEIGHT ?= 160
DIAMETER ?= 80
EDGE ?=
SIZE_rectangle ?= $(if $(EDGE),e$(EDGE:mm=),g1122)
SIZE_disc ?= $(if $(EDGE),e$(EDGE:mm=),g452)
# What all specimens have besides, as a setting of the mesh: FABRIC='granite|--material~FILE' gives them the phases of a material.
FABRIC ?=
# Threads of a run: those of the allocation.
THREADS ?= $(or $(SLURM_CPUS_PER_TASK),1)
LAUNCH ?=
OPTIONS ?=
GF ?=
OPEN ?=
LAW ?=
MAX_STRAIN ?=
# The rate tolerance of tests; empty: the solver's default, 0.003. Confined tests take 60 % of the steps with 0.006, uniaxial ones hardly
# fewer; share/doc/equilibrium.md has its effect on strengths. Brazilian tests are short and keep the solver's default.
UNIAXIAL ?=
CONFINED ?= 0.006
# Of most uniaxial tests only the peak is used, and the drop after it took half of a run: they end 15 % below the peak. Of 282 runs of the
# paper study that drop by 30 %, three peaks changed by more than 0.1 %: specimens whose grains interlock and whose stress rises again (cc a
# quarter of UCS). Empty: the solver's default, which runs with a strain limit of their own or with frames have too.
UNIAXIAL_PEAK_DROP ?= 0.15
export GRAINCRACK_FRAMES ?= 0

# --- runs ------------------------------------------------------------------------------------------------------------

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
# $(call lines,LIST): a line each, for the shell
lines = printf '%s\n' $(1)
# $(call same,TEXT,TEXT), but for white space: GNU make 4.3 sometimes leaves the last line end of a file that it reads.
same = $(call equal,x$(strip $(1))x,x$(strip $(2))x)
equal = $(and $(findstring $(1),$(2)),$(findstring $(2),$(1)))
# Text as one word of a list: ~ stands for a space, | is between the columns of a row.
word_of = $(subst $(space),~,$(strip $(1)))

# A setting is a word NAME|OPTIONS: what it adds to the name of a run or specimen, and to its options. $(call setting,NAME,OPTIONS)
setting = $(1)|$(call word_of,$(2))
options_of = $(foreach s,$(1),$(subst ~, ,$(word 2,$(subst |, ,$(s)))))
# $(call names_of,SETTINGS,BEFORE EACH)
names_of = $(subst $(space),,$(foreach s,$(1),$(2)$(firstword $(subst |, ,$(s)))))
# $(call at_point,TC,CC,PHIC)
at_point = $(call setting,tc$(1)_cc$(2)_phic$(3),--contact-tensile-strength $(1)MPa --contact-cohesion $(2)MPa --contact-friction-angle $(3)deg)
law = $(call setting,law-$(1),--contact-law $(1))
gf = $(call setting,gf$(1),--fracture-energy $(1)$(if $(filter mixed mode-i,$(1)),,J/m2))
os = $(call setting,os$(1),--contact-open-shear-strength $(1)MPa)
cap = $(call setting,cap$(1),--max-strain $(1))
drop = $(call setting,drop$(1),--peak-drop $(1))
rt = $(call setting,rt$(1),--rate-tolerance $(1))
maps := $(call setting,maps,--frames 20)

# $(call added,TEST,SETTINGS): what the user's variables add to the settings of a test, where these leave it open.
added = $(call unless,$(2),--contact-law,law,$(LAW)) $(call unless,$(2),--fracture-energy,gf,$(GF)) \
        $(call unless,$(2),--contact-open-shear-strength,os,$(OPEN)) $(call unless,$(2),--max-strain,cap,$(MAX_STRAIN)) \
        $(call unless,$(2),--peak-drop --max-strain --frames,drop,$(if $(filter uniaxial,$(1)),$(UNIAXIAL_PEAK_DROP))) \
        $(call unless,$(2),--rate-tolerance,rt,$(if $(filter triaxial,$(1)),$(CONFINED))$(if $(filter uniaxial,$(1)),$(UNIAXIAL)))
unless = $(and $(4),$(if $(strip $(foreach o,$(2),$(findstring $(o)~,$(1)))),,$(call $(3),$(4))))

# $(call run,TEST,SIZE,SEED,SETTINGS,LABELS,MATERIAL): the file of a run, whose row is noted. TEST: uniaxial, brazilian, tension, or triaxial8
# with the pressure in MPa. SIZE: e4, a mean edge in mm, or g452, a number of grains, and settings of the mesh; empty: the usual one.
# LABELS: entries of label_columns.
run = $(call run_of_shape,$(1),$(if $(filter brazilian,$(1)),disc,rectangle),$(2),$(3),$(4),$(5),$(6))
run_of_shape = $(call run_of_mesh,$(1),$(2),$(call sizes_of,$(or $(3),$(SIZE_$(2)))) $(FABRIC),$(4),$(5),$(6),$(7))
run_of_mesh = $(call run_on,$(1),$(2)$(extent_$(2))$(call names_of,$(3))-s$(4),$(mesh_$(2)) $(call options_of,$(3)) --seed $(4),$(5),$(6),$(7))
run_on = $(call note,$(1)_$(2),$(2),$(3),$(6),$(patsubst triaxial%,triaxial --confining-pressure %MPa,$(1)),$(4),$(5))
extent_rectangle = $(WIDTH)x$(HEIGHT)
extent_disc = $(DIAMETER)
mesh_rectangle = rectangle --width $(WIDTH)mm --height $(HEIGHT)mm
mesh_disc = disc --diameter $(DIAMETER)mm
sizes_of = $(foreach z,$(1),$(if $(findstring |,$(z)),$(z),$(call setting,$(z),$(patsubst e%,--edge %mm,$(z:g%=--grains %)))))
# $(call note,NAME,SPECIMEN,MESH,MATERIAL,TEST,SETTINGS,LABELS): the file of a run with such a row, for each of its columns a variable
note = $(call note_all,$(1),$(2),$(3),$(4),$(5),$(6) $(call added,$(firstword $(5)),$(6)),$(7))
note_all = $(call note_row,$(RUNS)/$(1)$(call names_of,$(6),_).h5,$(2),$(3),$(4),$(5) $(call options_of,$(6)),$(7))
note_row = $(call require_one,$(1),$(strip $(material_$(1)) $(solve_$(1))),$(strip $(4) $(5)))$(eval $(call row_variables,$(1),$(2),$(3),$(4),$(5),$(6)))$(1)
define row_variables
specimen_$(1) := $(2)
mesh_$(2) := $(strip $(3))
material_$(1) := $(strip $(4))
solve_$(1) := $(strip $(5))
labels_$(1) := $(or $(6),$(labels_$(1)))
endef
require_one = $(if $(2),$(if $(call same,$(2),$(3)),,$(error $(notdir $(1)): two runs of one name: "$(2)" and "$(3)"; each needs one of its own)))
# $(call rows_of,FILE): the rows of a table as words, with | before each column. $(call column_of,NUMBER,ROW): an entry of such a row
rows_of = $(foreach r,$(shell tail -n +2 $(1) | tr ' \t' '~|'),|$(r))
column_of = $(subst ~, ,$(patsubst |%,%,$(word $(1),$(subst |, |,$(2)))))
# $(call of_test,TEST,RUNS): those of a kind of test
of_test = $(strip $(foreach r,$(2),$(if $(filter $(1),$(firstword $(solve_$(r)))),$(r))))

# The table of the runs.
row = $(notdir $(1))|$(specimen_$(1))|$(call word_of,$(mesh_$(specimen_$(1))))|$(call word_of,$(material_$(1)))|$(call word_of,$(solve_$(1)))
rows = $(foreach r,$(runs),$(call row,$(r))$(if $(label_columns),|$(labels_$(r))))
runs_table = $(subst ~, ,$(subst |,$(tab),$(subst $(space),$(newline),file|specimen|mesh|material|solve$(label_columns:%=|%) $(strip $(rows)))))
# $(call changed,FILE,OPTIONS): FORCE if it was made by others. Files of which that is not known count as made by these.
changed = $(if $(file <$(1).options),$(if $(call same,$(file <$(1).options),$(2)),,FORCE))
run_options = $(mesh_$(specimen_$(1))) | $(material_$(1)) | $(solve_$(1))
changed_run = $(call changed,$(1),$(run_options))
# Position of a run in `runs`, from 1.
position = $(words $(subst |, ,$(firstword $(subst |$(1)|, ,|first|$(subst $(space),|,$(runs))|))))
# When this make began, and the runs that it has to make; set when it is first asked for.
started := $(shell date +%s)
missing_runs = $(eval missing_runs := $(sort $(filter-out $(wildcard $(RUNS)/*.h5),$(runs)) $(foreach r,$(runs),$(if \
    $(call changed_run,$(r)),$(r)))))$(missing_runs)
time_left = $(STUDIES)/lib/time-left $(started) $(words $(missing_runs)) $(RUNS)

# --- rules -----------------------------------------------------------------------------------------------------------

MESH = $(BIN)/graincrack-mesh
POST = $(BIN)/graincrack-post
# Several makes (a job array) may need the same specimen at the same time: a lock lets one of them make it.
$(SPECIMENS)/%.h5: $$(call changed,$$@,$$(mesh_$$*))
	@mkdir -p $(@D)
	@flock $(@D)/.lock bash -c 'mesh="$(mesh_$*)"; test -e $@ && test "$$(cat $@.options 2>/dev/null || echo "$$mesh")" = "$$mesh" || \
	    { $(MESH) $(mesh_$*) --quiet -o $@ && echo "$$mesh" >$@.options; }'

# A stopped run resumes from its checkpoint.
$(RUNS)/%.h5: $$(call changed_run,$$@) | $(SPECIMENS)/$$(specimen_$$@).h5
	@echo "[$(call position,$@)/$(words $(runs))] $*$$($(time_left))"
	@mkdir -p $(@D)$(if $(call changed_run,$@), && rm -f $@ $@.checkpoint $@.options)
	@$(if $(material_$@),$(POST) material with $(MATERIAL_FILE) $(material_$@) >$@.toml)
	@$(LAUNCH) $(BIN)/graincrack-solve $(firstword $(solve_$@)) $| $(wordlist 2,99,$(solve_$@)) --material $(if $(material_$@),$@.toml,$(MATERIAL_FILE)) --threads $(THREADS) --quiet $(OPTIONS) $$(! test -e $@.checkpoint || echo --restart $@.checkpoint) -o $@
	@echo '$(call run_options,$@)' >$@.options$(if $(material_$@), && rm $@.toml)

# Recipes for tables: $(call table,COMMAND) writes $@ completely or not at all.
define table
@mkdir -p $(@D)
@$(1) >$@.part && mv $@.part $@
endef
# The runs among the prerequisites, relative to $(RUNS), which keeps tables narrow and command lines short.
run_files = $(patsubst $(RUNS)/%,%,$(filter $(RUNS)/%,$^))
# $(call of_runs,SUBCOMMAND): the postprocessor on these runs
of_runs = cd $(RUNS) && $(POST) --quiet $(1) $(run_files)
# Tables that depend on runs depend on these too: with other SEEDS or laboratory values they are made anew, though no run is.
runs_list = $(HERE)/runs.tsv $(HERE)/material.toml
dry := $(findstring n,$(firstword -$(MAKEFLAGS)))
$(HERE)/runs.tsv: $$(if $$(call same,$$(file <$$@),$$(runs_table)),,FORCE)
	@$(if $(dry),,$(shell mkdir -p $(@D))$(file >$@.part,$(runs_table)))mv $@.part $@
$(HERE)/material.toml: $$(if $$(call same,$$(file <$$@),$$(file <$$(MATERIAL_FILE))),,FORCE)
	@mkdir -p $(@D) && cp $(MATERIAL_FILE) $@
FORCE:
lib = $(foreach f,$(1),-f $(STUDIES)/lib/$(f).awk)
# The query among the prerequisites, *.sql, of the tables among them.
query = $(POST) summarize $(filter %.tsv,$^) --sql $(filter %.sql,$^)
# Verdicts on the claims of a study: its claims.tsv is the first prerequisite, the tables of results are the others. A study may set
# claim_settings, --set NAME=VALUE for each {NAME} in its claims.
claims = $(call table,$(POST) --quiet claims $(filter %.tsv,$^) --study $(STUDY) $(claim_settings))
# A page, and the same as HTML: a text of the study, its claims, its tables and pictures, in the order of the prerequisites.
define page
$(call table,$(page_command))
@$(page_command) --format html >$(@:.md=.html).part && mv $(@:.md=.html).part $(@:.md=.html)
endef
page_command = $(POST) page $(filter-out $(RUNS)/% $(checks),$^) $(filter $(checks),$^)
# Quality checks of the runs of a page, a row for each test and pressure, at the end of the page.
checks = $(HERE)/checks.tsv
$(HERE)/page.md: $$(if $$(strip $$(runs)),$(checks))
$(checks): $$(runs) $(runs_list)
	$(call table,($(call of_runs,strength)) | $(POST) summarize strength=- --sql $(STUDIES)/lib/checks.sql)

.PHONY: all clean distclean print-runs print-here
# For job-array: the files of the runs, a line each, and the folder of the study.
print-runs:
	@$(if $(runs),$(call lines,$(runs)))
print-here:
	@echo $(HERE)
clean:
	rm -rf -- $(HERE)
distclean: clean
	@cd $(OUT) 2>/dev/null && rm -f -- $(patsubst $(OUT)/%,%,$(runs) $(runs:=.options) $(runs:=.checkpoint)) || true
