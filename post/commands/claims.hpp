// The command `claims`: verdicts on the claims of a paper.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command claims_command();

}  // namespace graincrack
