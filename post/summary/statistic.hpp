// Statistics of values, by the names that queries of `summarize` call them with.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace graincrack::summary {

using Number = std::optional<double>;

/// One number from the values of one argument or of two; an entry may be empty.
struct Statistic {
    std::size_t arguments = 1;
    std::function<Number(const std::vector<std::vector<Number>>&)> of;
};

/// Of one argument, over the rows that have an entry: mean, median, deviation (n − 1), low and high (the 95 % interval of the
/// mean by Student's t), half_interval. Of two arguments (x, y), over the rows that have an x: intercept and slope of the
/// straight line by least squares, exponent of the power law y ~ x^b through logarithms, each with the ends of its 95 % interval
/// as slope_low and slope_high; lack_of_fit, the p of the line's lack of fit against the scatter at equal x; rank_correlation by
/// Spearman; with x = σ3 and y = σ1, in one unit, cohesion (in that unit) and friction_angle (deg) of the line. Empty if a row
/// has an x and no y, or if there is no such fit.
const std::map<std::string, Statistic>& statistics();

}  // namespace graincrack::summary
