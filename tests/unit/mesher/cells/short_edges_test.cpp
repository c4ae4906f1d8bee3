#include "mesher/cells/short_edges.hpp"

#include <gtest/gtest.h>

#include "mesher/cells/polygon.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

/// A square of side 2 whose four cells meet in two points near the middle, `gap` apart; corners are fixed.
PlaneCells square(double gap, double lower = 0) {
    return cells_of(
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {lower, -1}, {1, 0}, {0, 1}, {-1, 0}, {-gap / 2, 0}, {gap / 2, 0}},
        {{0, 4, 9, 8, 7}, {4, 1, 5, 9}, {9, 5, 2, 6, 8}, {7, 8, 6, 3}},
        {{0, 4, 0, {}}, {4, 1, 0, {}}, {1, 5, 1, {}}, {5, 2, 1, {}}, {2, 6, 2, {}}, {6, 3, 2, {}}, {3, 7, 3, {}}, {7, 0, 3, {}}});
}

TEST(ShortEdges, MeetInTheMiddle) {
    PlaneCells cells = square(0.1);
    const ShortEdges edges = remove_short_edges(cells, 4);
    EXPECT_EQ(edges.n_removed, 1U);
    EXPECT_EQ(edges.n_left, 0U);
    ASSERT_EQ(cells.points.size(), 9U);
    EXPECT_EQ(cells.points.back(), (Point{0, 0}));
    for (std::size_t cell = 0; cell < 4; ++cell) EXPECT_EQ(cells.loop(cell).size(), 4U);
    EXPECT_EQ(areas_of(cells), (std::vector<double>{1, 1, 1, 1}));
    PlaneCells long_enough = square(0.34);
    EXPECT_EQ(remove_short_edges(long_enough, 4).n_removed, 0U);
    PlaneCells between = square(0.2);
    EXPECT_EQ(remove_short_edges(between, 4, very_short_edge).n_removed, 0U);
    EXPECT_EQ(remove_short_edges(between, 4).n_removed, 1U);
}

TEST(ShortEdges, LeaveFixedPoints) {
    // The end of the lower line comes near a corner, which takes it.
    PlaneCells cells = square(0.5, -0.96);
    EXPECT_EQ(remove_short_edges(cells, 4).n_removed, 1U);
    EXPECT_EQ(cells.points[0], (Point{-1, -1}));
    EXPECT_EQ(cells.sides.size(), 7U);
    EXPECT_EQ(cells.sides.front().to, 1);
    // Both ends fixed: the edge stays, and is told.
    PlaneCells stays = square(0.5, -0.96);
    const ShortEdges edges = remove_short_edges(stays, 5);
    EXPECT_EQ(edges.n_removed, 0U);
    EXPECT_EQ(edges.n_left, 1U);
}

TEST(ShortEdges, LeaveTrianglesTheirSides) {
    // A triangle with a short side, which would become a line.
    PlaneCells cells = cells_of({{0, 0}, {2, 0}, {2, 0.02}, {0, 2}}, {{0, 1, 2}, {0, 2, 3}},
                                {{0, 1, 0, {}}, {1, 2, 1, {}}, {2, 3, 2, {}}, {3, 0, 3, {}}});
    const ShortEdges edges = remove_short_edges(cells, 0);
    EXPECT_EQ(edges.n_removed, 0U);
    EXPECT_EQ(cells.points.size(), 4U);
}

}  // namespace
}  // namespace graincrack::mesher
