# Runs and a table of them, for the driver. Variables: WANTED, entries TEST:TOKENS; SIZE, unless the usual one; SEEDS; COMMAND of the
# postprocessor; TABLE, the file.
SIZE ?=
include ../common.mk
runs := $(foreach w,$(WANTED),$(foreach s,$(SEEDS),$(call run,$(firstword $(subst :, ,$(w))),$(SIZE),$(s),$(lastword $(subst :, ,$(w))))))
all: $(TABLE)
$(TABLE): $(runs) FORCE
	$(call table,$(call of_runs,$(COMMAND)))
# Prints the specimen of the first run, which is made if it does not exist.
specimen: $(SPECIMENS)/$(word 2,$(call words_of,$(firstword $(runs)))).h5
	@echo $<
