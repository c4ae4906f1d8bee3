// The command `report`: a test or a set of tests as one HTML page.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command report_command();

}  // namespace graincrack
