// The command `cracks`: a run as a folder of files for ParaView and scripts.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command cracks_command();
Command classes_command();

}  // namespace graincrack
