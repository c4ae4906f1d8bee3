// The command `properties`: what specimens measure beside what the laboratory did.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command properties_command();

}  // namespace graincrack
