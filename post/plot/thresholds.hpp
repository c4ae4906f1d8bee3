// Crack initiation and damage on the curve they are read from.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/command.hpp"
#include "post/measure/load_curve.hpp"

namespace graincrack {

/// Stress and volumetric strain, 2D and pseudo-3D, against gauge strain up to just past the peak, with the thresholds by
/// name. \throws InputError for a test that is no compression test
Drawing draw_thresholds(const RunData& run);

Command thresholds_plot();

}  // namespace graincrack
