// The commands `ccd design`, `ccd fit` and `ccd solve`: central composite designs.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command ccd_command();

}  // namespace graincrack
