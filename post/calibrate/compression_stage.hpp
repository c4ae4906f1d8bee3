// cc and φc, from strengths without and with confining pressure.
#pragma once

#include "post/calibrate/progress.hpp"

namespace graincrack::calibrate {

/// Sets cc and φc near both compressive targets by single tests. \throws RunsMissing
void find_start(Progress& progress);
/// Sets cc and φc by designs about them. \param round from 0 \throws RunsMissing, Ended
void fit_compression(Progress& progress, std::size_t round);

}  // namespace graincrack::calibrate
