// The energy balance of a run over its strain.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/command.hpp"
#include "post/measure/load_curve.hpp"

namespace graincrack {

/// Every term of the energy balance against axial strain (time, for a run that was not loaded along its axis), per metre of
/// thickness; the largest residual in the subtitle.
Drawing draw_energy(const RunData& run, const PictureStyle& style = {});

Command energy_plot();

}  // namespace graincrack
