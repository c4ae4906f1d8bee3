// Strength against mean edge on logarithmic scales.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/fit/size_effect.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// Every run as a point, each series with its power law (log–log) and, for tensile strengths, the slope of the theory.
Drawing draw_size_effect(const std::vector<SizeSeries>& series, const PictureStyle& style = {});

Command size_effect_plot();

}  // namespace graincrack
