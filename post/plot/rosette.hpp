// Rosette of a run: the orientations of its cracks, by mode, over those of all facets.
#pragma once

#include <string>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/cracks/rosette.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// Two roses, tensile and shear: petals are shares of the length of cracks in bins of 10°, the line behind them the
/// shares of the specimen's own facets. Petals are as long as the share; an orientation has no sense, so both halves are equal.
/// \throws InputError without cracks
/// \param definition of its cracks in words
Drawing draw_rosette(const Rosette& rosette, const std::string& title, const std::string& run, const std::string& definition,
                     const PictureStyle& style = {});

Command rosette_plot();

}  // namespace graincrack
