// The commands `ccd design`, `ccd fit` and `ccd solve`: central composite designs.
#pragma once

#include "post/command.hpp"

namespace graincrack {

Command ccd_command();

}  // namespace graincrack
