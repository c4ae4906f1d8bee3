// Acoustic emission: the number of events at or above each magnitude.
#pragma once

#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/cracks/emission.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// log10 of the number of events at or above a magnitude, with the slope b from the completeness on, if
/// the magnitudes lie on one.
/// \throws InputError without events
Drawing draw_emission(const std::vector<EmissionEvent>& events, const std::string& title, const std::string& run,
                      const PictureStyle& style = {});

Command emission_plot();

}  // namespace graincrack
