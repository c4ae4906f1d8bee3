// Micro-cracks over the loading, by mode and pair of minerals.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/cracks/crack_counts.hpp"
#include "post/options/command.hpp"
#include "post/plot/abscissa.hpp"

namespace graincrack {

/// Counts over a test, stress behind them on a scale of its own. With one pair: tensile red, shear black; with several: a colour
/// a pair, shear dashed; pairs without cracks of a mode have no curve, and beyond six those with the fewest share one.
/// \param counts at every row of the run's history \param definition of its cracks in words
Drawing draw_counts(const CrackCounts& counts, const RunData& run, const std::string& definition,
                    Abscissa abscissa = Abscissa::time, const PictureStyle& style = {});

Command counts_plot();

}  // namespace graincrack
