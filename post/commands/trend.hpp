// The command `trend`: a column of tables against another.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command trend_command();

}  // namespace graincrack
