// Lines of equal value on a grid (marching squares).
#pragma once

#include <array>
#include <vector>

namespace graincrack {

/// Values at the nodes of a grid: value[j * nx + i] at (x[i], y[j]).
struct GridValues {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> value;
};

/// Line segments where the value is `level`; cells with a NaN corner are left out.
std::vector<std::array<std::array<double, 2>, 2>> contour_segments(const GridValues& grid, double level);

}  // namespace graincrack
