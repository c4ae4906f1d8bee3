// Micro-cracks over the loading, by mode and pair of minerals.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/command.hpp"
#include "post/cracks/crack_counts.hpp"

namespace graincrack {

/// Counts against axial strain, stress behind them on a scale of its own. With one pair: tensile red, shear black; with
/// several: a colour a pair, shear dashed.
/// \param definition of its cracks in words
Drawing draw_counts(const CrackCounts& counts, const RunData& run, const std::string& definition, const PictureStyle& style = {});

Command counts_plot();

}  // namespace graincrack
