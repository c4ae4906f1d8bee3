// E and ν of the grains, from assemblages.
#pragma once

#include "post/calibrate/progress.hpp"

namespace graincrack::calibrate {

/// Sets E and ν of the grains. \throws RunsMissing, Ended
void find_elasticity(Progress& progress);

}  // namespace graincrack::calibrate
