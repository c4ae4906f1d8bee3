#include "post/chart/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace graincrack {
namespace {

GridValues distance_grid(std::size_t n) {
    GridValues grid;
    for (std::size_t i = 0; i < n; ++i) grid.x.push_back(-1 + 2.0 * static_cast<double>(i) / static_cast<double>(n - 1));
    grid.y = grid.x;
    for (double y : grid.y) {
        for (double x : grid.x) grid.value.push_back(std::hypot(x, y));
    }
    return grid;
}

TEST(Contour, CircleHasItsLength) {
    double length = 0;
    for (const auto& [a, b] : contour_segments(distance_grid(101), 0.5)) {
        EXPECT_NEAR(std::hypot(a[0], a[1]), 0.5, 3e-4);  // linear in cells of 0.02: sagitta 0.02²/(8 · 0.5)
        length += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
    EXPECT_NEAR(length, 3.14159265, 3e-3);
}

TEST(Contour, NothingWhereTheLevelIsNotOrTheValueIsUnknown) {
    GridValues grid = distance_grid(21);
    EXPECT_TRUE(contour_segments(grid, 5).empty());
    for (double& value : grid.value) value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(contour_segments(grid, 0.5).empty());
}

}  // namespace
}  // namespace graincrack
