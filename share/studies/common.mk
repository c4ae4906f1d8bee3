# Rules and variables that all studies share: specimens, runs, tables and pages.
#
# The name of a run contains its settings, so that studies which need the same run share it and it is made once:
#
#     $(OUT)/runs/ROCK/uniaxial_rectangle80x160g1122-s2_tc18_cc122_phic53.h5
#
#     uniaxial, brazilian, tension, triaxial8          the test; with the pressure in MPa
#     rectangle80x160g1122-s2, disc80e4-s2             the specimen: mm; number of grains or mean edge in mm; seed
#     disc80g452d1-s2                                  a disc of six diameters, loaded along the one at 30°
#     rectangle80x160g1122n32-s2                       with a notch of 32 mm
#     tc18 cc122 phic53 gf90 os7.7                     contact options in MPa, degrees and J/m²; gfmixed, gfmode-i
#     law-NAME cap0.05 maps                            the law; --max-strain; with frames for crack maps
#     dm0.4 sf0.8 rt0.012                              --damping, --time-step-fraction, --rate-tolerance
#     half                                             half the platen speed throughout (--rate-share 0.5)
#     drop0.15                                         --peak-drop, of uniaxial runs
#     NAME                                             options_NAME of the study
#
# and ROCK is the material with four digits that change with its values. A study sets `runs`, the runs that it needs, by
# $(call run,TEST,SIZE,SEED,TOKENS), and includes this file. Users set:
#
#     make SEEDS="1 2"         other seeds               make EDGE=4mm        another grain size
#     make MATERIAL=my.toml    another rock              make OUT=/scratch    where results go
#     make -j 2                runs side by side         make THREADS=2       threads of a run
#     make LAUNCH="srun …"     command before a run      make MAX_STRAIN=0.01 strain limit of runs without a peak
#     make GF=90               fracture energy, J/m²     make OPEN=7.7        shear strength of open contacts, MPa
#     make LAW=scaled          another contact law       make UNIAXIAL_PEAK_DROP=0.3   uniaxial runs to a larger drop below the peak; none: to the strain limit
#     make CONFINED= UNIAXIAL=                           runs with the solver's default loading rate
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
.PRECIOUS: $(SPECIMENS)/rectangle%.h5 $(SPECIMENS)/disc%.h5

# --- the rock --------------------------------------------------------------------------------------------------------

MATERIAL ?= augig-granite
MATERIAL_FILE := $(abspath $(firstword $(wildcard $(filter /%,$(MATERIAL)) $(CALLED_FROM)/$(MATERIAL) $(STUDIES)/../materials/$(MATERIAL).toml)))
$(if $(MATERIAL_FILE),,$(error $(or $(material_variable),MATERIAL)=$(MATERIAL): no such file, nor a name in share/materials))
MATERIAL_ID := $(basename $(notdir $(MATERIAL_FILE))).$(shell sed -e 's/\#.*//' -e 's/[[:space:]]*$$//' $(MATERIAL_FILE) | \
                 awk '/^\[/ { on = $$0 != "[laboratory]" } on && NF' | cksum | awk '{ printf "%04x", $$1 % 65536 }')
RUNS := $(OUT)/runs/$(MATERIAL_ID)
# $(call of_material,contact.cohesion): a value as a bare number, in MPa, degrees, mm
of_material = $(shell $(POST) material value $(1) $(MATERIAL_FILE))
# The material's own contact strengths, as tokens of a run
point_of_material = tc$(call of_material,contact.tensile_strength)_cc$(call of_material,contact.cohesion)_phic$(call of_material,contact.friction_angle)

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
# Threads of a run: those of the allocation.
THREADS ?= $(or $(SLURM_CPUS_PER_TASK),1)
LAUNCH ?=
OPTIONS ?=
GF ?=
OPEN ?=
LAW ?=
MAX_STRAIN ?=
# The loading rate of tests, as tokens of their names; empty: the solver's default, a rate tolerance of 0.0015. This value reduces the time
# of tests to some two thirds; share/doc/equilibrium.md has its effect on strengths.
# Brazilian tests are short and keep the solver's default.
UNIAXIAL ?= rt0.003
CONFINED ?= rt0.003
# Of most uniaxial tests only the peak is used, and the drop after it took half of a run: they end 15 % below the peak. Of 282 runs of the
# paper study that drop by 30 %, three peaks changed by more than 0.1 %: specimens whose grains interlock and whose stress rises again (cc a
# quarter of UCS). Empty: the solver's default, which runs with a strain limit of their own or with frames have too.
UNIAXIAL_PEAK_DROP ?= 0.15
export GRAINCRACK_FRAMES ?= 0

# --- names of runs ---------------------------------------------------------------------------------------------------

comma := ,
empty :=
space := $(empty) $(empty)
# $(call times,SHARES,VALUE): numbers
times = $(shell awk 'BEGIN { n = split("$(1)", s, " "); for (i = 1; i <= n; ++i) printf "%s%.6g", (i > 1 ? " " : ""), s[i] * $(2) }')
# $(call unique,LIST): without repetitions, in its order
unique = $(if $(1),$(firstword $(1)) $(call unique,$(filter-out $(firstword $(1)),$(1))))
# $(call lines,LIST): a line each, for the shell
lines = printf '%s\n' $(1)
shape_of = $(if $(filter brazilian,$(1)),disc,rectangle)
extent_rectangle = $(WIDTH)x$(HEIGHT)
extent_disc = $(DIAMETER)
# Tokens that the user's variables add to a run.
user_tokens = $(if $(findstring _law-,$(1)),,$(if $(LAW),_law-$(LAW)))$(if $(findstring _gf,$(1)),,$(if $(GF),_gf$(GF)))$(if $(findstring _os,$(1)),,$(if $(OPEN),_os$(OPEN)))$(if $(findstring _cap,$(1)),,$(if $(MAX_STRAIN),_cap$(MAX_STRAIN)))
rate_of = $(if $(filter triaxial%,$(1)),$(CONFINED),$(if $(filter uniaxial,$(1)),$(UNIAXIAL)))
rate_tokens = $(subst $(space),,$(patsubst %,_%,$(call rate_of,$(1))))
# $(call drop_token,TEST,_TOKENS)
drop_token = $(and $(filter uniaxial,$(1)),$(UNIAXIAL_PEAK_DROP),$(if $(strip $(foreach t,_drop _cap _maps,$(findstring $(t),$(2)))),,_drop$(UNIAXIAL_PEAK_DROP)))
# $(call run,TEST,SIZE,SEED,TOKENS); no SIZE: the usual one. TOKENS are joined by _, as in tc18_cc122
run = $(call run_name,$(1),$(call shape_of,$(1)),$(2),$(3),$(if $(4),_$(4)))
run_name = $(RUNS)/$(1)_$(2)$(extent_$(2))$(or $(3),$(SIZE_$(2)))-s$(4)$(5)$(call user_tokens,$(5))$(call drop_token,$(1),$(5))$(call rate_tokens,$(1)).h5

words_of = $(subst _, ,$(notdir $(1)))
tokens_of = $(wordlist 3,99,$(call words_of,$(1)))
test_command = $(if $(filter triaxial%,$(1)),triaxial,$(1))
test_options = $(patsubst triaxial%,--confining-pressure %MPa,$(filter triaxial%,$(1)))
energy_unit = $(if $(filter gfmixed gfmode-i,$(1)),,J/m2)
option_of = $(or $(options_$(1)),$(strip \
    $(patsubst tc%,--contact-tensile-strength %MPa,$(filter tc%,$(1))) \
    $(patsubst cc%,--contact-cohesion %MPa,$(filter cc%,$(1))) \
    $(patsubst phic%,--contact-friction-angle %deg,$(filter phic%,$(1))) \
    $(patsubst gf%,--fracture-energy %$(call energy_unit,$(1)),$(filter gf%,$(1))) \
    $(patsubst os%,--contact-open-shear-strength %MPa,$(filter os%,$(1))) \
    $(patsubst law-%,--contact-law %,$(filter law-%,$(1))) \
    $(patsubst cap%,--max-strain %,$(filter cap%,$(1))) \
    $(patsubst drop%,--peak-drop %,$(filter drop%,$(1))) \
    $(patsubst dm%,--damping %,$(filter dm%,$(1))) \
    $(patsubst sf%,--time-step-fraction %,$(filter sf%,$(1))) \
    $(patsubst rt%,--rate-tolerance %,$(filter rt%,$(1))) \
    $(patsubst half,--rate-share 0.5,$(filter half,$(1))) \
    $(patsubst maps,--frames 20,$(filter maps,$(1)))))
# "uniaxial, seed 2, tc=18MPa": the text of a line of progress
describe_token = $(or $(patsubst tc%,tc=%MPa,$(filter tc%,$(1))),$(patsubst cc%,cc=%MPa,$(filter cc%,$(1))),$(patsubst phic%,phic=%deg,$(filter phic%,$(1))),$(patsubst cap%,to a strain of %,$(filter cap%,$(1))),$(1))
describe = $(call describe_test,$(word 1,$(1))), $(word 1,$(subst -s, ,$(word 2,$(1)))), seed $(lastword $(subst -s, ,$(word 2,$(1))))$(subst $(space)|,$(comma) , $(foreach t,$(wordlist 3,99,$(1)),|$(call describe_token,$(t))))
describe_test = $(if $(filter triaxial%,$(1)),triaxial at $(patsubst triaxial%,%MPa,$(1)),$(1))
# Position of a run in `runs`, from 1.
position = $(words $(subst |, ,$(firstword $(subst |$(1)|, ,|first|$(subst $(space),|,$(runs))|))))
# When this make began, and the runs that were not there then; set when it is first asked for.
started := $(shell date +%s)
missing_runs = $(eval missing_runs := $(filter-out $(wildcard $(RUNS)/*.h5),$(runs)))$(missing_runs)
time_left = $(STUDIES)/lib/time-left $(started) $(words $(missing_runs)) $(RUNS)

# --- rules -----------------------------------------------------------------------------------------------------------

MESH = $(BIN)/graincrack-mesh
POST = $(BIN)/graincrack-post
# $(call sizes,80x160g1122-s2): 80 160 1122 2
sizes = $(subst x, ,$(subst g, ,$(subst e, ,$(subst d, ,$(subst n, ,$(subst -s, ,$(1)))))))
size_option = $(if $(findstring g,$(1)),--grains $(2),--edge $(2)mm)
# Several makes (a job array) may need the same specimen at the same time: a lock lets one of them make it.
define mesh
@mkdir -p $(@D)
@flock $(@D)/.lock bash -c 'test -e $@ || $(MESH) $(1) --seed $(lastword $(call sizes,$*)) --quiet -o $@'
endef
$(SPECIMENS)/rectangle%.h5:
	$(call mesh,rectangle --width $(word 1,$(call sizes,$*))mm --height $(word 2,$(call sizes,$*))mm $(call size_option,$*,$(word 3,$(call sizes,$*))) $(if $(findstring n,$*),--notch $(word 4,$(call sizes,$*))mm))
$(SPECIMENS)/disc%.h5:
	$(call mesh,disc --diameter $(word 1,$(call sizes,$*))mm $(call size_option,$*,$(word 2,$(call sizes,$*))) $(if $(findstring d,$*),--diameters 6 --loaded-diameter $(word 3,$(call sizes,$*))))

# The names of specimen and rock contain their settings: an existing run need never be made again. What was stopped goes on from its
# checkpoint.
$(RUNS)/%.h5: | $(SPECIMENS)/$$(word 2,$$(call words_of,$$*)).h5
	@echo "[$(call position,$@)/$(words $(runs))] $(call describe,$(call words_of,$*))$$($(time_left))"
	@mkdir -p $(@D)
	@$(LAUNCH) $(BIN)/graincrack-solve $(call test_command,$(word 1,$(call words_of,$*))) $| $(call test_options,$(word 1,$(call words_of,$*))) --material $(MATERIAL_FILE) --threads $(THREADS) --quiet $(OPTIONS) $(foreach t,$(call tokens_of,$*),$(call option_of,$(t))) $$(! test -e $@.checkpoint || echo --restart $@.checkpoint) -o $@

# Recipes for tables: $(call table,COMMAND) writes $@ completely or not at all.
define table
@mkdir -p $(@D)
@$(1) >$@.part && mv $@.part $@
endef
# The runs among the prerequisites, relative to $(RUNS), which keeps tables narrow and command lines short.
run_files = $(patsubst $(RUNS)/%,%,$(filter $(RUNS)/%,$^))
# $(call of_runs,SUBCOMMAND): the postprocessor on these runs
of_runs = cd $(RUNS) && $(POST) --quiet $(1) $(run_files)
# Tables that depend on runs depend on this list too: with other SEEDS they are made anew, though no run is.
runs_list = $(HERE)/runs.txt
material_sum := $(firstword $(shell cksum <$(MATERIAL_FILE)))
runs_listed = $(material_sum) $(runs)
$(runs_list): $$(if $$(filter-out $$(runs_listed),$$(file <$$@))$$(filter-out $$(file <$$@),$$(runs_listed)),FORCE)
	@mkdir -p $(@D)
	@$(call lines,$(runs_listed)) >$@
FORCE:
lib = $(foreach f,$(1),-f $(STUDIES)/lib/$(f).awk)
# $(call column,NAME,EXPRESSION): a column of `summarize`. $(call sample,EXPRESSION,UNIT): deviation and 95 % interval of a mean.
column = --column '$(1)=$(2)'
sample = $(call column,deviation_$(2),deviation($(1))) $(call column,low_$(2),low($(1))) $(call column,high_$(2),high($(1)))
without_peak = $(call column,without_peak,n(peak_kind where peak_kind!=drop))
# Whichever strength a test measures, MPa.
strength = tensile_strength_MPa | peak_compressive_stress_MPa
# Verdicts on the claims of a study: its claims.tsv is the first prerequisite, the tables of results are the others. A study may set
# claim_settings, --set NAME=VALUE for each {NAME} in its claims.
claims = $(call table,$(POST) --quiet claims $(filter %.tsv,$^) --study $(STUDY) $(claim_settings))
# $(call labels,COLUMN…,ROW…): a table for `summarize --look-up`; a row is RUN|LABEL…, columns have | between them too.
labels = $(call table,printf '%s\n' 'file|$(1)' $(patsubst $(RUNS)/%,'%',$(sort $(2))) | tr '|' '\t')
# $(call labelled,RUNS,LABEL): such rows
labelled = $(foreach r,$(1),$(r)|$(2))
# $(call mean_and_half,EXPRESSION): a mean with half of its 95 % interval, as a text
mean_and_half = [{mean($(1)):.1f} ± {half_interval($(1)):.1f};{mean($(1)):.1f}]
# A page, and the same as HTML: a text of the study, its claims, its tables and pictures, in the order of the prerequisites.
define page
$(call table,$(page_command))
@$(page_command) --format html >$(@:.md=.html).part && mv $(@:.md=.html).part $(@:.md=.html)
endef
page_command = $(POST) page $(filter-out $(RUNS)/% $(checks),$^) $(filter $(checks),$^)
# Quality checks of the runs of a page, a row for each test and pressure, at the end of the page.
checks = $(HERE)/checks.tsv
$(HERE)/page.md: $$(if $$(strip $$(runs)),$(checks))
# $(call at_most,COLUMN,FORMAT): in per cent
at_most = {100 * largest($(1)):$(2)}
check_columns = $(call column,runs,n(file)) $(call column,damping_carried_at_most_percent,$(call at_most,damping_load,.2f)) \
                $(call column,energy_balance_off_by_at_most_percent,$(call at_most,energy_balance_error,.3f)) \
                $(call column,platen_forces_differ_at_most_percent,$(call at_most,platen_force_difference,.2f)) \
                $(call column,damping_carried_more_than_2_percent_in,[{file where damping_load>0.02};none])
$(checks): $$(runs) $(runs_list)
	$(call table,($(call of_runs,strength)) | $(POST) summarize - --by test --by confining_pressure_MPa $(check_columns))

.PHONY: all clean distclean print-runs print-here
# For job-array: the files of the runs, a line each, and the folder of the study.
print-runs:
	@$(if $(runs),$(call lines,$(runs)))
print-here:
	@echo $(HERE)
clean:
	rm -rf -- $(HERE)
distclean: clean
	@cd $(OUT) 2>/dev/null && rm -f -- $(patsubst $(OUT)/%,%,$(runs) $(addsuffix .checkpoint,$(runs))) || true
