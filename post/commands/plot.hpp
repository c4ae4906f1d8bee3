// The command `plot` with all its pictures.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command plot_command();

}  // namespace graincrack
