// The commands `strength`, `moduli` and `toughness`: what each run gives by itself, one row per run.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command strength_command();
Command moduli_command();
Command toughness_command();

}  // namespace graincrack
