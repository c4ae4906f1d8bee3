// The command `material`: a template of a material file.
#pragma once

#include "post/command.hpp"

namespace graincrack {

Command material_command();

}  // namespace graincrack
