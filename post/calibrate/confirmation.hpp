// The calibrated point on new specimens, and its predictions.
#pragma once

#include "post/calibrate/progress.hpp"

namespace graincrack::calibrate {

/// Tests the point on new specimens; sets the outcomes. \param round from 0 \throws RunsMissing
Ending confirm(Progress& progress, std::size_t round);
/// Adds predictions to the outcomes. \param round of the confirmation \throws RunsMissing
void predict(Progress& progress, std::size_t round);

}  // namespace graincrack::calibrate
