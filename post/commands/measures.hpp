// The commands `strength`, `moduli` and `toughness`: what each run gives by itself, a row a run.
#pragma once

#include "post/command.hpp"

namespace graincrack {

Command strength_command();
Command moduli_command();
Command toughness_command();

}  // namespace graincrack
