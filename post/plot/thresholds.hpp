// Crack initiation and damage on the curve they are read from.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// Above, the stress against gauge strain up to just past the peak, with the thresholds by name; below, the volumetric strain, 2D
/// and pseudo-3D. \throws InputError for a test that is no compression test
Drawing draw_thresholds(const RunData& run, const PictureStyle& style = {});

Command thresholds_plot();

}  // namespace graincrack
