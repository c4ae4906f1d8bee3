# The make that the user typed, for lib/resumable. A make that another one has called leaves it as it is.
ifeq ($(origin TO_RESUME),undefined)
export TO_RESUME := $(strip $(shell xargs -0 bash -c 'printf "%q " "$$@"' - 2>/dev/null </proc/$$PPID/cmdline))
endif
