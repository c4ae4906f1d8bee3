# Rocks calibrated from the surface of their kind, each by the steps of README.md:
#
#     make -C share/studies/surface -f rocks.mk -j 2                       all, some half an hour of one processor
#     make -C share/studies/surface -f rocks.mk ROCKS=new-granite -j 2     one
#
# Each is given rocks/NAME.toml: the four granites and the tutorial's marble with the targets and bounds that they had when designs of
# their own calibrated them, and a granite that nobody calibrated, whose values were written down first. An interrupted calibration
# resumes. Leaves $(OUT)/by-kind: a calibration's folder each, and by-kind.tsv: how each ended, its runs and seconds of one processor.
#
# Rules, committed before the first run. (1) The end word is the result. (2) A rock that was calibrated before has to be so again, and the
# mean of new specimens of each fitted target has to be within the union of both 95 % intervals; parameters that the data determine have to
# be within the interval of before, or their intervals overlap. (3) At most 160 runs a rock, 70 in the median. (4) The new granite: at most
# 100 runs; then six specimens of each fitted test on seeds that nothing used (CONFIRM) have means within the bounds, or an interval that
# reaches into them.
ROCKS ?= new-granite wausau-granite augig-granite marble lac-du-bonnet-granite red-bohus-granite
include ../lib/places.mk
BIN ?= $(abspath ../../../build/bin)

HERE := $(OUT)/by-kind
tables := $(foreach r,$(ROCKS),$(HERE)/calibrate/$(r)/strength.tsv)
.PHONY: all $(ROCKS)
all: $(ROCKS)
	@{ printf 'rock\tended\truns\tprocessor_s\n'; for r in $(ROCKS); do folder=$(HERE)/calibrate/$$r; \
	    $(BIN)/graincrack-post summarize $$folder/strength.tsv --sql "SELECT '$$r' AS rock, '$$(sed -n '1s/.*: //p' $$folder/report.md)' \
	    AS ended, count(*) AS runs, round(sum(wall_time_s)) AS processor_s FROM strength" | tail -n +2; done; } >$(HERE)/by-kind.part
	@mv $(HERE)/by-kind.part $(HERE)/by-kind.tsv
	@cat $(HERE)/by-kind.tsv
$(ROCKS):
	@-$(MAKE) --no-print-directory -C ../calibrate ROCK=$(CURDIR)/rocks/$@.toml BIN=$(BIN) OUT=$(HERE)
.NOTPARALLEL:
