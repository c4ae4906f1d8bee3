// The command line of graincrack-post.
#pragma once

#include <optional>

#include "post/commands/commands.hpp"

namespace graincrack {

/// Reads the command line; empty if it was answered already (--help, --version, --print-config). \throws UsageError
std::optional<PostOptions> read_options(int argc, const char* const* argv);

}  // namespace graincrack
