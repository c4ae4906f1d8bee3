// Statistics of the rows of a group, by the names that columns of `summarize` are written with.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace graincrack::summary {

using Number = std::optional<double>;

/// One number from the values of one column or of two; a row's entry may be empty.
struct Statistic {
    std::size_t columns = 1;
    std::function<Number(const std::vector<std::vector<Number>>&)> of;
};

/// Of one column, over the rows that have an entry: n, first, sum, mean, deviation (n − 1), low and high (the 95 % interval of
/// the mean by Student's t), half_interval, smallest, largest. Of two columns (x, y), over the rows that have an x: intercept and
/// slope of the straight line by least squares, exponent of the power law y ~ x^b through logarithms; with x = σ3 and y = σ1, in
/// one unit, cohesion (in that unit) and friction_angle (deg) of the line. Empty if a row has an x and no y, or where there is no
/// such fit. \return null if there is no statistic of this name
const Statistic* find_statistic(const std::string& name);

/// Their names, for messages.
std::string statistic_names();

}  // namespace graincrack::summary
