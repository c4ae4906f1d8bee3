// graincrack-post claims.
#pragma once

#include "post/command.hpp"

namespace graincrack {

Command claims_command();

}  // namespace graincrack
