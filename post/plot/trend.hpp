// Rows of tables with the lines fitted through them.
#pragma once

#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/fit/trend.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// Points, line and 95 % interval of the mean for each group; both scales logarithmic for a power law.
Drawing draw_trend(const std::vector<TrendRows>& groups, const TrendOptions& options, const PictureStyle& style = {});

Command trend_plot();

}  // namespace graincrack
