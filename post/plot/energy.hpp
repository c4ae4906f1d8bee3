// The energy balance of a run over a test.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "post/plot/abscissa.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// The terms of the energy balance over a test, per metre of thickness, and where its largest stress is; the largest residual in
/// the subtitle. Terms below a thousandth of the largest are named, not drawn.
Drawing draw_energy(const RunData& run, Abscissa abscissa = Abscissa::time, const PictureStyle& style = {});

Command energy_plot();

}  // namespace graincrack
