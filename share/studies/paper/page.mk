# The page of `paper`, from the results of the studies.
runs =
include ../common.mk
calibration := $(OUT)/calibrate/$(basename $(notdir $(MATERIAL_FILE)))
theirs = $(patsubst %,$(OUT)/%/claims.tsv,$(AT_THEIRS))
ours = $(wildcard $(patsubst %,$(HERE)/ours/%/claims.tsv,$(AT_OURS)))
minerals = $(patsubst %,$(HERE)/minerals/%/claims.tsv,$(AT_MINERALS))
all: $(HERE)/page.md
# A point of which there is no study has a table without a claim.
points = $(foreach point,theirs ours minerals,$(patsubst %,$(point)=%,$(or $($(point)),no-claims.tsv)))
$(HERE)/claims.tsv: merge.sql no-claims.tsv $(theirs) $(ours) $(minerals)
	$(call table,$(POST) summarize $(points) --sql $<)
$(HERE)/summary.tsv: summary.sql $(HERE)/claims.tsv
	$(call table,$(query))
$(HERE)/calibration.md: $(calibration)/report.md calibration.awk
	$(call table,awk -v report=../calibrate/$(notdir $(calibration))/report.md -f calibration.awk $<)
$(HERE)/page.md: about.md $(HERE)/summary.tsv $(HERE)/claims.tsv $(HERE)/calibration.md pictures.md
	$(page)
	@echo "$@"
