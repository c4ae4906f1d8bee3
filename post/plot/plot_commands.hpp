// The pictures as commands of `plot`, one row each.
#pragma once

#include <vector>

#include "post/options/command.hpp"

namespace graincrack {

/// Returns the commands in the order of --help. \throws UsageError for an unsuitable picture name before drawing
std::vector<Command> plot_commands();

}  // namespace graincrack
