# Where make was called, where results go, and what the user typed. Included by each Makefile that users call.
places := $(patsubst %/,%,$(dir $(abspath $(lastword $(MAKEFILE_LIST)))))
# A relative path is relative to where make was called first.
export CALLED_FROM ?= $(PWD)
# Of a source tree in share/studies, of an installation where make was called first.
OUT ?= $(if $(wildcard $(places)/../../../CMakeLists.txt),$(places:/lib=),$(CALLED_FROM))/results
override OUT := $(abspath $(if $(filter /%,$(OUT)),,$(CALLED_FROM)/)$(OUT))
# For lib/resumable. A make that another one has called leaves it as it is.
ifeq ($(origin TO_RESUME),undefined)
export TO_RESUME := $(strip $(shell xargs -0 bash -c 'printf "%q " "$$@"' - 2>/dev/null </proc/$$PPID/cmdline))
endif
