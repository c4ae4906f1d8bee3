// The command `fpz`: the fracture process zone of a rock in numbers, every quantity the paper derives with its equation.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command fpz_command();

}  // namespace graincrack
