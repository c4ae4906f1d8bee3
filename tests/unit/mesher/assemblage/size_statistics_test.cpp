#include "mesher/assemblage/size_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

/// Two equilateral triangles of edge 1.
PlaneCells rhombus() {
    PlaneCells cells;
    const double h = std::sqrt(3) / 2;
    cells.points = {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}};
    cells.corners = {0, 1, 3, 1, 2, 3};
    cells.start = {0, 3, 6};
    cells.edges = {{0, 1}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    return cells;
}

TEST(SizeStatistics, TheElongationOfATriangleIsThatOfItsMap) {
    PlaneCells cells = rhombus();
    cells.edges = {{0, 1}, {0, 3}, {1, 3}};            // an equilateral triangle has none
    EXPECT_NEAR(elongation_of(cells).ratio, 1, 1e-7);  // square root of a round-off
    for (const double angle : {0.0, 0.4, -1.2}) {
        PlaneCells longer = cells;
        for (Point& p : longer.points) p = Stretch({2.5, angle}).elongated(p);
        EXPECT_NEAR(elongation_of(longer).ratio, 2.5, 1e-12);
        EXPECT_NEAR(elongation_of(longer).angle, angle, 1e-12);
    }
}

TEST(SizeStatistics, SpreadAndAnglesAreThoseOfTheCells) {
    const SizeField size(rectangle(4, 4), 1, parse_grading("along=y,from=1,to=1.5", "--grade"), {}, 0);
    PlaneCells cells = rhombus();
    const SizeStatistics s =
        size_statistics_of(rectangle(4, 4), cells, size, 1, parse_grading("along=y,from=1,to=1.5", "--grade"));
    EXPECT_NEAR(s.min_angle, std::numbers::pi / 3, 1e-12);
    EXPECT_GT(s.spread, 0.005);
    EXPECT_LT(s.spread, 0.05);
    EXPECT_EQ(s.graded_edge[0], 0) << "no edge in the lowest eighth";
}

}  // namespace
}  // namespace graincrack::mesher
