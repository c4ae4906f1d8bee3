// The pictures as commands of `plot`: a row each.
#pragma once

#include <vector>

#include "post/options/command.hpp"

namespace graincrack {

/// In the order of --help. \throws UsageError for the name of a picture before it is drawn
std::vector<Command> plot_commands();

}  // namespace graincrack
