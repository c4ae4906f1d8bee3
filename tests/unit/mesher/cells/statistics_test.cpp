#include "mesher/cells/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

TEST(Statistics, AreThoseOfTwoGrains) {
    const PlaneCells cells = cells_of({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, {{0, 1, 2}, {2, 3, 0}});
    const MeshStatistics s = statistics_of(rectangle(1, 1), cells);
    const double mean = (4 + std::sqrt(2)) / 5;
    EXPECT_NEAR(s.mean_edge, mean, 1e-15);
    EXPECT_NEAR(s.edge_variation, std::sqrt(6.0 / 5 - mean * mean) / mean, 1e-12);
    EXPECT_DOUBLE_EQ(s.min_edge, 1);
    EXPECT_DOUBLE_EQ(s.max_edge, std::sqrt(2));
    EXPECT_NEAR(s.mean_diameter, std::sqrt(2 / 3.14159265358979), 1e-12);
    EXPECT_NEAR(s.diameter_variation, 0, 1e-12);
    EXPECT_NEAR(s.min_angle, 3.14159265358979 / 4, 1e-12);
    EXPECT_NEAR(s.psi6, 1.0 / 5, 1e-12);  // the sides cancel, the diagonal has e^(i 270°)
    EXPECT_NEAR(s.area_error, 0, 1e-15);
}

TEST(Statistics, AreThoseOfAPolygonThatIsNotConvex) {
    const PlaneCells cells = cells_of({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {{0, 1, 2, 3, 4, 5}});
    const MeshStatistics s = statistics_of({"polygon", {{cells.points, {0, 0, 0, 0, 0, 0}}}, {}}, cells);
    EXPECT_NEAR(s.mean_diameter, std::sqrt(4 * 3 / 3.14159265358979), 1e-12);
    EXPECT_NEAR(s.mean_edge, 8.0 / 6, 1e-15);
    EXPECT_NEAR(s.area_error, 0, 1e-15);
}

}  // namespace
}  // namespace graincrack::mesher
