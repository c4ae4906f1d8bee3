# Specimens and runs of a study; common.mk includes it. A run is a row of a table: the name of its file, the name of its specimen, and the
# options of three tools as they would be typed,
#
#     file      uniaxial_rectangle80x160g1122-s2_tc18_cc122_phic53.h5
#     specimen  rectangle80x160g1122-s2
#     mesh      rectangle --width 80mm --height 160mm --grains 1122 --seed 2             of graincrack-mesh
#     material  --set phases.contrast=0.75                                               of graincrack-post material with; empty: the rock
#     solve     uniaxial --contact-tensile-strength 18MPa --contact-cohesion 122MPa …    of graincrack-solve
#
# and, behind them, what the study calls it by (`label_columns`): queries join tables of results with it. Names are for readers and say
# what is special in a run, so that studies that need the same run share it and it is made once; nothing reads them. The table is
# $(OUT)/STUDY/runs.tsv. A run whose options have changed is made again: FILE.options has those that it was made with.
#
# Runs start in the order of `runs`: a study lists the longest first, so that processors finish at about the same time.
RUNS := $(OUT)/runs/$(MATERIAL_ID)
SPECIMENS := $(OUT)/specimens
.PRECIOUS: $(SPECIMENS)/%.h5

# --- variables of users ----------------------------------------------------------------------------------------------

SEEDS ?= 1 2 3 4 5
$(foreach s,$(SEEDS),$(if $(shell printf '%s' '$(s)' | tr -d 0-9),\
    $(error SEEDS=$(SEEDS): $(s) is no whole number; SEEDS="1 2 3" fits)))
# The paper's: 80 mm x 160 mm, 1,122 grains; disc of 80 mm, 452 grains.
WIDTH ?= 80
HEIGHT ?= 160
DIAMETER ?= 80
EDGE ?=
SIZE_rectangle ?= $(if $(EDGE),e$(EDGE:mm=),g1122)
SIZE_disc ?= $(if $(EDGE),e$(EDGE:mm=),g452)
# An addition to all specimens, as a setting of the mesh: FABRIC='granite|--material~FILE' gives them the phases of a material.
FABRIC ?=
# Threads of a run: those of the allocation.
THREADS ?= $(or $(SLURM_CPUS_PER_TASK),1)
# Ranks of a run, and what starts several (share/doc/speed.md). Ranks are not bound to cores: runs side by side would be bound to the
# same ones, and the threads of a rank to one.
RANKS ?= 1
MPIRUN ?= mpirun --bind-to none
$(foreach v,RANKS THREADS,$(if $(shell echo '$($(v))' | grep -xE '[1-9][0-9]*'),,\
    $(error $(v)=$($(v)): no whole number above 0; $(v)=2 fits)))
LAUNCH ?=
# The destination of the messages of a run, and the action if it fails.
MESSAGES ?= --quiet
IF_IT_FAILS ?=
OPTIONS ?=
GF ?=
OPEN ?=
LAW ?=
MAX_STRAIN ?=
# The rate tolerance of tests; empty: the solver's default, 0.003. Confined tests take 60 % of the steps with 0.006, uniaxial ones hardly
# fewer; share/studies/equilibrium/README.md has its effect on strengths. Brazilian tests are short and keep the solver's default.
UNIAXIAL ?=
CONFINED ?= 0.006
# Most uniaxial tests are used for their peak alone, and the drop after it took half of a run: they end 15 % below the peak. Of 282 runs of the
# paper study that drop by 30 %, three peaks changed by more than 0.1 %: specimens whose grains interlock and whose stress rises again (cc a
# quarter of UCS). Empty: the solver's default, which runs with a strain limit of their own or with frames have too.
UNIAXIAL_PEAK_DROP ?= 0.15
# Frames of runs whose settings have none.
FRAMES ?= 0

# --- settings --------------------------------------------------------------------------------------------------------

# A setting is a word NAME|OPTIONS: what it adds to the name of a run or specimen, and to its options. $(call setting,NAME,OPTIONS)
setting = $(1)|$(call word_of,$(2))
options_of = $(foreach s,$(1),$(subst ~, ,$(word 2,$(subst |, ,$(s)))))
# $(call names_of,SETTINGS,BEFORE EACH)
names_of = $(subst $(space),,$(foreach s,$(1),$(2)$(firstword $(subst |, ,$(s)))))
# $(call at_point,TC,CC,PHIC)
at_point = $(call setting,tc$(1)_cc$(2)_phic$(3),$(strength_options))
strength_options = --contact-tensile-strength $(1)MPa --contact-cohesion $(2)MPa --contact-friction-angle $(3)deg
law = $(call setting,law-$(1),--contact-law $(1))
gf = $(call setting,gf$(1),--fracture-energy $(1)$(if $(filter mixed mode-i,$(1)),,J/m2))
os = $(call setting,os$(1),--contact-open-shear-strength $(1)MPa)
cap = $(call setting,cap$(1),--max-strain $(1))
drop = $(call setting,drop$(1),--peak-drop $(1))
rt = $(call setting,rt$(1),--rate-tolerance $(1))
maps := $(call setting,maps,--frames 20)

# $(call added,TEST,SETTINGS): what the user's variables add to the settings of a test, where these leave it open.
added = $(call unless,$(2),--contact-law,law,$(LAW)) \
        $(call unless,$(2),--fracture-energy,gf,$(GF)) \
        $(call unless,$(2),--contact-open-shear-strength,os,$(OPEN)) \
        $(call unless,$(2),--max-strain,cap,$(MAX_STRAIN)) \
        $(call unless,$(2),--peak-drop --max-strain --frames,drop,$(if $(filter uniaxial,$(1)),$(UNIAXIAL_PEAK_DROP))) \
        $(call unless,$(2),--rate-tolerance,rt,$(if $(filter triaxial,$(1)),$(CONFINED))$(if $(filter uniaxial,$(1)),$(UNIAXIAL)))
# $(call unless,SETTINGS,OPTIONS,SETTING,VALUE): a setting, if there is a value and none of the options among the settings
unless = $(and $(4),$(if $(strip $(foreach o,$(2),$(findstring $(o)~,$(1)))),,$(call $(3),$(4))))

# --- runs ------------------------------------------------------------------------------------------------------------

# $(call run,TEST,SIZE,SEED,SETTINGS,LABELS,MATERIAL): the file of a run, whose row is noted. TEST: uniaxial, brazilian, tension, or
# triaxial8 with the pressure in MPa. SIZE: e4, a mean edge in mm, or g452, a number of grains, and settings of the mesh; empty: the usual
# one. LABELS: entries of label_columns.
run = $(call note,$(1)_$(run_specimen),$(run_specimen),$(run_mesh),$(6),$(run_test),$(4),$(5))
# The names and options of a run; $(1) to $(6) are those of `run`.
run_shape = $(if $(filter brazilian,$(1)),disc,rectangle)
run_sizes = $(call sizes_of,$(or $(2),$(SIZE_$(run_shape)))) $(FABRIC)
run_specimen = $(run_shape)$(extent_$(run_shape))$(call names_of,$(run_sizes))-s$(3)
run_mesh = $(extent_options_$(run_shape)) $(call options_of,$(run_sizes)) --seed $(3)
run_test = $(patsubst triaxial%,triaxial --confining-pressure %MPa,$(1))
extent_rectangle = $(WIDTH)x$(HEIGHT)
extent_disc = $(DIAMETER)
extent_options_rectangle = rectangle --width $(WIDTH)mm --height $(HEIGHT)mm
extent_options_disc = disc --diameter $(DIAMETER)mm
sizes_of = $(foreach z,$(1),$(if $(findstring |,$(z)),$(z),$(call setting,$(z),$(patsubst e%,--edge %mm,$(z:g%=--grains %)))))

# $(call note,NAME,SPECIMEN,MESH,MATERIAL,TEST,SETTINGS,LABELS): the file of a run with such a row, for each of its columns a variable
note = $(call note_row,$(note_file),$(2),$(3),$(4),$(5) $(call options_of,$(note_settings)),$(7))
note_settings = $(6) $(call added,$(firstword $(5)),$(6))
note_file = $(RUNS)/$(1)$(call names_of,$(note_settings),_).h5
# $(call note_row,FILE,SPECIMEN,MESH,MATERIAL,SOLVE,LABELS)
note_row = $(call require_one,$(1),$(strip $(material_$(1)) $(solve_$(1))),$(strip $(4) $(5)))$(eval $(row_variables))$(1)
define row_variables
specimen_$(1) := $(2)
mesh_$(2) := $(strip $(3))
material_$(1) := $(strip $(4))
solve_$(1) := $(strip $(5))
labels_$(1) := $(or $(6),$(labels_$(1)))
endef
require_one = $(if $(2),$(if $(call same,$(2),$(3)),,$(error $(notdir $(1)): two runs of one name: "$(2)" and "$(3)"; each needs \
    one of its own)))
# $(call of_test,TEST,RUNS): those of a kind of test
of_test = $(strip $(foreach r,$(2),$(if $(filter $(1),$(firstword $(solve_$(r)))),$(r))))

# --- the table of the runs -------------------------------------------------------------------------------------------

options_of_run = $(call word_of,$(mesh_$(specimen_$(1))))|$(call word_of,$(material_$(1)))|$(call word_of,$(solve_$(1)))
row = $(notdir $(1))|$(specimen_$(1))|$(options_of_run)$(if $(label_columns),|$(labels_$(1)))
rows = file|specimen|mesh|material|solve$(label_columns:%=|%) $(strip $(foreach r,$(runs),$(call row,$(r))))
runs_table = $(subst ~, ,$(subst |,$(tab),$(subst $(space),$(newline),$(rows))))
dry := $(findstring n,$(firstword -$(MAKEFLAGS)))
$(HERE)/runs.tsv: $$(if $$(call same,$$(file <$$@),$$(runs_table)),,FORCE)
	@$(if $(dry),,$(shell mkdir -p $(@D))$(file >$@.part,$(runs_table)))mv $@.part $@

# --- rules -----------------------------------------------------------------------------------------------------------

# $(call changed,FILE,OPTIONS): FORCE if it was made by others. Files of which that is not known count as made by these.
changed = $(if $(file <$(1).options),$(if $(call same,$(file <$(1).options),$(2)),,FORCE))
run_options = $(mesh_$(specimen_$(1))) | $(material_$(1)) | $(solve_$(1))
changed_run = $(call changed,$(1),$(run_options))

# Several makes (a job array) may need the same specimen at the same time: a lock lets one of them make it.
$(SPECIMENS)/%.h5: $$(call changed,$$@,$$(mesh_$$*))
	@mkdir -p $(@D)
	@flock $(@D)/.lock bash -c 'mesh="$(mesh_$*)"; \
	    test -e $@ && test "$$(cat $@.options 2>/dev/null || echo "$$mesh")" = "$$mesh" || \
	    { $(MESH) $(mesh_$*) --quiet -o $@ && echo "$$mesh" >$@.options; }'

# A stopped run resumes from its checkpoint.
$(RUNS)/%.h5: $$(call changed_run,$$@) | $(SPECIMENS)/$$(specimen_$$@).h5
	@echo "[$(call position,$@)/$(words $(runs))] $*$$($(time_left))"
	@mkdir -p $(@D)$(if $(call changed_run,$@), && rm -f $@ $@.checkpoint $@.options)
	@$(if $(material_$@),$(POST) material with $(MATERIAL_FILE) $(material_$@) >$@.toml)
	@$(if $(filter 0,$(MAKELEVEL)),$(STUDIES)/lib/resumable )$(LAUNCH) $(if $(filter-out 1,$(RANKS)),$(MPIRUN) -n $(RANKS) )$(BIN)/graincrack-solve $(firstword $(solve_$@)) $| $(wordlist 2,99,$(solve_$@)) $(other_options) -o $@ $(IF_IT_FAILS)
	@echo '$(call run_options,$@)' >$@.options$(if $(material_$@), && rm $@.toml)
other_options = --material $(if $(material_$@),$@.toml,$(MATERIAL_FILE)) --threads $(THREADS) $(MESSAGES) $(OPTIONS) \
                $(if $(findstring --frames,$(solve_$@) $(OPTIONS)),,--frames $(FRAMES)) \
                $$(! test -e $@.checkpoint || echo --restart $@.checkpoint)
# Position of a run in `runs`, from 1.
position = $(words $(subst |, ,$(firstword $(subst |$(1)|, ,|first|$(subst $(space),|,$(runs))|))))
# When this make began, and the runs that it has to make; set when it is first asked for.
started := $(shell date +%s.%N)
remade = $(foreach r,$(runs),$(if $(call changed_run,$(r)),$(r)))
missing_runs = $(eval missing_runs := $(sort $(filter-out $(wildcard $(RUNS)/*.h5),$(runs)) $(remade)))$(missing_runs)
time_left = $(STUDIES)/lib/time-left $(started) $(words $(missing_runs)) $(RUNS) $$PPID
