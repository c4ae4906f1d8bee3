// The command `size-effect`: strength against grain size.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command size_effect_command();

}  // namespace graincrack
