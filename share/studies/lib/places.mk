# Where make was called, where results go, and what the user typed. Included by each Makefile that users call.
places := $(patsubst %/,%,$(dir $(abspath $(lastword $(MAKEFILE_LIST)))))
# Names that make or a shell would take apart, or run, are refused, by their texts before anything expands them.
hash := \#
open := (
close := )
special := $$ ` ' " $(hash) \ ; & | < > $(open) $(close) * ?
is_given = $(filter command environment,$(firstword $(origin $(1))))
is_special = $(filter-out 0 1,$(words $(value $(1))))$(strip $(foreach c,$(special),$(findstring $(c),$(value $(1)))))
$(foreach v,OUT BIN ROCK MATERIAL,$(if $(call is_given,$v),$(if $(call is_special,$v),$(error $v: "$(value $v)": has a space or one of \
    $(special), which make does not take: rename the file or its folder))))
# A relative path is relative to where make was called first.
export CALLED_FROM ?= $(PWD)
# Of a source tree in share/studies, of an installation where make was called first.
OUT ?= $(if $(wildcard $(places)/../../../CMakeLists.txt),$(places:/lib=),$(CALLED_FROM))/results
override OUT := $(abspath $(if $(filter /%,$(OUT)),,$(CALLED_FROM)/)$(OUT))
# For lib/resumable. A make that another one has called leaves it as it is.
ifeq ($(origin TO_RESUME),undefined)
export TO_RESUME := $(strip $(shell xargs -0 bash -c 'printf "%q " "$$@"' - 2>/dev/null </proc/$$PPID/cmdline))
endif
