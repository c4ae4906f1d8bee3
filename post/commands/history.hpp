// The command `history`: the rows of a run; of a loading program also its probes and stages.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command history_command();

}  // namespace graincrack
