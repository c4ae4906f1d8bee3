// The command `export`: the mesh of a specimen for other programs.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command export_command();

}  // namespace graincrack
