# The page of `paper`, from the results of the studies.
runs =
include ../common.mk
calibration := $(OUT)/calibrate/$(basename $(notdir $(MATERIAL_FILE)))
theirs = $(patsubst %,$(OUT)/%/claims.tsv,$(AT_THEIRS))
ours = $(wildcard $(patsubst %,$(HERE)/ours/%/claims.tsv,$(AT_OURS)))
minerals = $(patsubst %,$(HERE)/minerals/%/claims.tsv,$(AT_MINERALS))
all: $(HERE)/page.md
$(HERE)/claims.tsv: $(theirs) $(ours) $(minerals) merge.awk
	$(call table,awk -v n_theirs=$(words $(theirs)) -v n_ours=$(words $(ours)) $(call lib,columns) -f merge.awk $(theirs) $(ours) $(minerals))
$(HERE)/summary.tsv: $(HERE)/claims.tsv
	$(call table,awk $(call lib,columns) -f summary.awk $<)
$(HERE)/calibration.md: $(calibration)/report.md calibration.awk
	$(call table,awk -v report=../calibrate/$(notdir $(calibration))/report.md -f calibration.awk $<)
$(HERE)/page.md: about.md $(HERE)/summary.tsv $(HERE)/claims.tsv $(HERE)/calibration.md pictures.md
	$(page)
	@echo "$@"
