# A calibrated rock whose boundaries are bridged besides, on new specimens: what bridges change of what was calibrated without them.
#
#     make -C share/studies/rocks -f bridged.mk MATERIAL=wausau-granite-calibrated
#
# BRIDGES are what is set in the material. Specimens are as large as those of calibrations, half-discs HALF_DISC mm; no study uses their
# seeds. Leaves $(OUT)/rocks/bridged-MATERIAL.tsv: the means of each property, with 95 % intervals.
MATERIAL ?= wausau-granite-calibrated
BRIDGES ?= --set ratios.bridging_strength=0.55 --set ratios.bridging_energy=1 \
    --set pairs.within.bridging_strength=0 --set pairs.within.bridging_energy=0
PRESSURE ?= 8
HALF_DISC ?= 75
DISCS ?= 6
TENSIONS ?= 5
RECTANGLES ?= 4
HALF_DISCS ?= 3
FIRST_SEED ?= 770001
STUDY = rocks/bridged-$(basename $(notdir $(MATERIAL)))
include ../common.mk

grain := $(call of_material,fabric.grain_size)
width := $(call times,11.3333,$(grain))
crystals := --grain-size $(grain)mm --material $(MATERIAL_FILE)
# $(call of,TEST,NAME,SHAPE,OPTIONS,NUMBER)
of = $(foreach s,$(shell seq $(FIRST_SEED) $(call times,1,$(FIRST_SEED) + $(5) - 1)),$(call \
    note,$(1)_$(2)d$(grain)-bridged-s$(s),$(2)d$(grain)-s$(s),$(3) $(crystals) --seed $(s),$(BRIDGES),$(1) $(4)))
rectangle := rectangle --width $(width)mm --height $(call times,2,$(width))mm
disc := disc --diameter $(call times,17,$(grain))mm
half_disc := half-disc --diameter $(HALF_DISC)mm --slit $(call times,0.25,$(HALF_DISC))mm
uniaxial := $(call of,uniaxial,rectangle,$(rectangle),--rate-tolerance 0.006,$(RECTANGLES))
bend := $(call of,bend,half-disc$(HALF_DISC),$(half_disc),--span $(call times,0.6,$(HALF_DISC))mm --plane stress,$(HALF_DISCS))
runs := $(call of,triaxial,rectangle,$(rectangle),--confining-pressure $(PRESSURE)MPa,$(RECTANGLES)) \
    $(bend) $(call of,tension,rectangle,$(rectangle),--plane stress,$(TENSIONS)) $(uniaxial) \
    $(call of,brazilian,disc,$(disc),,$(DISCS))

all: $(HERE).tsv
$(HERE)/strength.tsv: $$(runs) $(runs_list)
	$(call table,$(call of_runs,strength --all-columns))
$(HERE)/moduli.tsv: $(uniaxial) $(runs_list)
	$(call table,$(call of_runs,moduli --all-columns))
$(HERE)/toughness.tsv: $(bend) $(runs_list)
	$(call table,$(call of_runs,toughness))
$(HERE).tsv: bridged.sql $(HERE)/strength.tsv $(HERE)/moduli.tsv $(HERE)/toughness.tsv
	$(call table,$(query))
