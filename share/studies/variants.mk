# Studies of variants of a rock of crystals that break; their Makefiles include it in place of common.mk (`brittle`, `toughness`).
#
# variants.tsv has the variants: energies of boundaries (J/m²) and their cohesion (MPa); the strength of contacts within crystals over that of
# boundaries and their energy; what else they set in the material; their mesh; their loading. Tests: uniaxial, triaxialN under N MPa, and
# tension on rectangles of CRYSTALS crystals, brazilian on discs and half-disc on half-discs of crystals of the same size, with a slit of SLIT
# of their radius. RECTANGLES, DISCS and HALF_DISCS are numbers of specimens; TESTS_x, RECTANGLES_x … are those of a variant x. Tension and
# bending are in plane stress.
CRYSTALS ?= 300
WIDTH ?= 40
HEIGHT ?= 80
DIAMETER ?= 60
HALF_DISC ?= 80
RECTANGLES ?= 3
DISCS ?= 6
HALF_DISCS ?= 3
SLIT ?= 0.5
TESTS ?= uniaxial triaxial8 tension brazilian half-disc
RATE ?= 0.006
DISC_RATE ?= 0.003
# Direct tension ends when so much of its peak is lost; its work of fracture is known from 0.9 on.
TENSION_DROP ?= 0.95
# The same of Brazilian tests; empty: the solver's default
BRAZILIAN_DROP ?=
UNIAXIAL_PEAK_DROP ?= 0.15
# Read once: a default that is expanded at each use would start a shell for each variant and part.
parts_of_table := $(shell tail -n +2 variants.tsv | cut -f 2)
PARTS ?= $(call unique,$(parts_of_table))
VARIANTS ?= $(foreach r,$(table_of_variants),$(if $(filter $(PARTS),$(call entry,2)),$(call entry,1)))
include $(dir $(lastword $(MAKEFILE_LIST)))common.mk

# --- what variants.tsv says of a variant -----------------------------------------------------------------------------

table_of_variants := $(call rows_of,variants.tsv)
entry = $(call column_of,$(1),$(r))
set = $(if $(2),--set $(1)=$(2)$(3))
factor = $(call set,pairs.within.$(1),$(2))
boundary = $(call set,contact.fracture_energy,$(1),J/m2) $(call set,contact.mode_ii_fracture_energy,$(2),J/m2) $(call set,contact.cohesion,$(3),MPa)
# $(call within,STRENGTH,ENERGY,ENERGY OF BOUNDARIES): the zone in which contacts slide apart is as long as that of boundaries
within = $(if $(1),$(foreach key,tensile_strength cohesion open_shear_strength,$(call factor,$(key),$(1))) \
    $(call factor,mode_ii_fracture_energy,$(call times,$(1),$(1))) $(call factor,fracture_energy,$(call times,$(2),1 / $(3))))
# Bridges are between crystals alone.
between := $(foreach key,bridging_strength bridging_energy,$(call factor,$(key),0))
define variant
material_of_$(1) := $(call boundary,$(3),$(4),$(5)) $(call within,$(6),$(7),$(3)) $(if $(findstring bridging,$(8)),$(between)) $(8)
mesh_of_$(1) := $(9)
solve_of_$(1) := $(10)
endef
$(foreach r,$(table_of_variants),$(eval $(call variant,$(call entry,1),$(call entry,2),$(call entry,3),$(call entry,4),$(call entry,5),$(call \
    entry,6),$(call entry,7),$(call entry,8),$(call entry,9),$(call entry,10))))
$(foreach v,$(filter-out $(foreach r,$(table_of_variants),$(call entry,1)),$(VARIANTS) $(BEST)),$(error VARIANTS: $(v): no such variant in variants.tsv))
parts_shown = $(call unique,$(foreach r,$(table_of_variants),$(if $(filter $(call entry,1),$(VARIANTS)),$(call entry,2))))

# --- runs ------------------------------------------------------------------------------------------------------------

label_columns = variant|series
# $(call crystals_on,AREA): as many crystals on an area, in mm², as CRYSTALS on a rectangle
crystals_on = $(shell awk 'BEGIN { printf "%.0f", $(CRYSTALS) * ($(1)) / ($(WIDTH) * $(HEIGHT)) }')
area_of_disc = 0.785398 * $(1)^2
area_of_half-disc = 0.392699 * $(1)^2
# $(call crystals,NUMBER,VARIANT): variants with the same mesh have the same specimens.
crystals = $(call setting,crystals$(1)$(call name_of_mesh,$(mesh_of_$(2))),--tessellation trigon --grains $(1) --spread 0.3 \
    --material $(MATERIAL_FILE) $(or $(mesh_of_$(2)),--elements-per-crystal 8))
name_of_mesh = $(if $(1),$(subst $(space),,$(subst --,-,$(subst per-crystal,,$(subst boundaries,,$(1))))))
rate_of = $(if $(filter brazilian tension half-disc,$(1)),$(DISC_RATE),$(RATE))
in_plane_stress := $(call setting,stress,--plane stress)
settings_of_tension := $(in_plane_stress) $(call drop,$(TENSION_DROP)) $(call cap,0.001)
settings_of_brazilian := $(if $(BRAZILIAN_DROP),$(call drop,$(BRAZILIAN_DROP)))
settings_of_half-disc := $(in_plane_stress) $(call drop,0.3)
# $(call settings_of,TEST,VARIANT)
settings_of = $(call setting,$(2),$(solve_of_$(2))) $(call rt,$(call rate_of,$(1))) $(settings_of_$(1))
seed_of = $(if $(filter brazilian,$(1)),$(2),$(shell expr 900 + $(2)))
# $(call run_of,TEST,VARIANT,NUMBER,SETTINGS,SERIES)
run_of = $(call run,$(1),$(call crystals,$(if $(filter brazilian,$(1)),$(crystals_of_disc),$(CRYSTALS)),$(2)),$(call \
    seed_of,$(1),$(3)),$(call settings_of,$(1),$(2)) $(4),$(2)|$(or $(5),$(1)),$(material_of_$(2)))
crystals_of_disc := $(call crystals_on,$(call area_of_disc,$(DIAMETER)))
# $(call bent,SHAPE,MESH,AREA,SPAN,VARIANT,NUMBER,SERIES): bending of a specimen; lengths in mm
bent = $(call bent_as,$(1)$(call names_of,$(call crystals,$(call crystals_on,$(3)),$(5)))-s$(6),$(2) $(call options_of,$(call \
    crystals,$(call crystals_on,$(3)),$(5))) --seed $(6),$(4),$(5),$(7))
bent_as = $(call note,bend_$(1),$(1),$(2),$(material_of_$(4)),bend --span $(3)mm,$(call settings_of,half-disc,$(4)),$(4)|$(call word_of,$(5)))
# $(call bend_of,VARIANT,NUMBER,SLIT,DIAMETER,SERIES): a half-disc, whose slit is a share of its radius
bend_of = $(call bent,half-disc$(4)slit$(3),half-disc --diameter $(4)mm --slit $(call times,$(3),$(4) / 2)mm,$(call \
    area_of_half-disc,$(4)),$(call times,0.6,$(4)),$(1),$(2),$(5))
specimens = $(shell seq $(or $($(1)_$(2)),$($(1))))
tests_of = $(or $(TESTS_$(1)),$(TESTS))
on_rectangles = $(foreach s,$(call specimens,RECTANGLES,$(2)),$(call run_of,$(1),$(2),$(s),$(3),$(4)))
on_half_discs = $(foreach s,$(call specimens,HALF_DISCS,$(1)),$(call bend_of,$(1),$(s),$(2),$(HALF_DISC),half-disc $(2)))
tested = $(foreach t,$(filter-out brazilian half-disc,$(tests_of)),$(call on_rectangles,$(t),$(1))) \
    $(if $(filter brazilian,$(tests_of)),$(foreach s,$(call specimens,DISCS,$(1)),$(call run_of,brazilian,$(1),$(s)))) \
    $(if $(filter half-disc,$(tests_of)),$(call on_half_discs,$(1),$(SLIT)))

# --- tables ----------------------------------------------------------------------------------------------------------

# What brittle.sql reads, of the runs that a study has when it comes to the end of its Makefile, and the criteria of share/studies/brittle.
BRITTLE := $(STUDIES)/brittle
tables = $(foreach t,strength moduli cracks toughness ends runs,$(HERE)/$(t).tsv)
$(HERE)/strength.tsv: $$(filter-out $$(call of_test,program,$$(runs)),$$(runs)) $(runs_list)
	$(call table,$(call of_runs,strength --all-columns))
$(HERE)/moduli.tsv: $$(call of_test,uniaxial,$$(runs)) $(runs_list)
	$(call table,$(call of_runs,moduli --all-columns))
$(HERE)/cracks.tsv: $$(call of_test,uniaxial,$$(runs)) $(runs_list)
	$(call table,$(call of_runs,classes))
$(HERE)/toughness.tsv: $$(call of_test,bend,$$(runs)) $(runs_list)
	$(call table,$(if $(run_files),$(call of_runs,toughness),printf 'file\tmode_i_toughness_MPa.m^0.5\n-\t\n'))
# The last row of the history of confined tests and of direct tension.
$(HERE)/ends.tsv: $$(call of_test,triaxial tension,$$(runs)) $(runs_list)
	$(call table,$(last_rows))
$(HERE)/brittle.tsv: $(BRITTLE)/brittle.sql $(tables)
	$(call table,$(query) --set WIDTH=$(WIDTH))
$(HERE)/criteria.tsv: $(BRITTLE)/criteria.sql $(BRITTLE)/bounds.tsv $(HERE)/brittle.tsv
	$(call table,$(query))
