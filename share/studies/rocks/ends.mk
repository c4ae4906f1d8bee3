# Red Bohus granite to large strains with the calibrated contacts: stresses at the end over peaks, which were not fitted.
#
#     make -C share/studies/rocks -f ends.mk -j 2        16 tests, to 4 % strain
#
# Leaves $(OUT)/ends/strength.tsv and ends.tsv.
STUDY = ends
MATERIAL ?= red-bohus-granite-calibrated
SEEDS ?= 1 2 3 4
PRESSURES ?= 100 75 50 20
# The specimens of its calibration.
WIDTH ?= 46
HEIGHT ?= 92
MAX_STRAIN ?= 0.04
include ../common.mk
override FABRIC := granite|--material~$(MATERIAL_FILE)
runs := $(foreach p,$(PRESSURES),$(foreach s,$(SEEDS),$(call run,triaxial$(p),,$(s),$(call setting,whole,--peak-drop none))))
all: $(HERE)/ends.tsv
$(HERE)/strength.tsv: $(runs) $(runs_list)
	$(call table,$(call of_runs,strength))
$(HERE)/ends.tsv: ends.sql $(HERE)/strength.tsv
	$(call table,$(query))
	@cat $@
