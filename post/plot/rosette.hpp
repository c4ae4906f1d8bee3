// Rosette of a run: which way its cracks run, by mode, over the directions its facets offered.
#pragma once

#include <string>

#include "post/chart/drawing.hpp"
#include "post/command.hpp"
#include "post/cracks/rosette.hpp"

namespace graincrack {

/// Two roses, tensile and shear: petals are shares of the length of cracks in bins of 10°, the outline behind them the
/// shares of the specimen's own facets. Petals are as long as the share; a line has no head, so both halves are equal.
/// \throws InputError without cracks
Drawing draw_rosette(const Rosette& rosette, const std::string& title, const std::string& run);

Command rosette_plot();

}  // namespace graincrack
