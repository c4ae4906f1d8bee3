// The command `material`: a template of a material file, values of one, one with other values.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command material_command();

}  // namespace graincrack
