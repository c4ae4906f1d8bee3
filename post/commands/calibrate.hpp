// The command `calibrate`: the next runs of a calibration, or its end.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command calibrate_command();

}  // namespace graincrack
