#include "mesher/cells/relaxed_corners.hpp"

#include <gtest/gtest.h>

#include "mesher/cells/polygon.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

/// A rectangle of 3 × 1 in three cells of a row; corners of the rectangle are the first points.
PlaneCells row_of_three(double first, double second) {
    return cells_of(
        {{0, 0}, {3, 0}, {3, 1}, {0, 1}, {first, 0}, {first, 1}, {second, 0}, {second, 1}},
        {{0, 4, 5, 3}, {4, 6, 7, 5}, {6, 1, 2, 7}},
        {{0, 4, 0, {}}, {4, 6, 0, {}}, {6, 1, 0, {}}, {1, 2, 1, {}}, {2, 7, 2, {}}, {7, 5, 2, {}}, {5, 3, 2, {}}, {3, 0, 3, {}}});
}

TEST(RestoredAreas, WallsMoveAlongTheBoundary) {
    PlaneCells cells = row_of_three(0.8, 2.1);
    EXPECT_LE(restore_areas(cells, 4, {1, 1, 1}), 1e-10);
    // The shortest moves are those of both ends of a wall alike.
    const PlaneCells expected = row_of_three(1, 2);
    for (std::size_t p = 0; p < cells.points.size(); ++p) {
        EXPECT_NEAR(cells.points[p].x, expected.points[p].x, 1e-9);
        EXPECT_EQ(cells.points[p].y, expected.points[p].y);
    }
}

TEST(RestoredAreas, InnerPointsMoveFreely) {
    // A square of side 2 with four cells around a point; the ends of walls on the boundary are fixed.
    PlaneCells cells = cells_of(
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0.1, -0.2}},
        {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}},
        {{0, 4, 0, {}}, {4, 1, 0, {}}, {1, 5, 1, {}}, {5, 2, 1, {}}, {2, 6, 2, {}}, {6, 3, 2, {}}, {3, 7, 3, {}}, {7, 0, 3, {}}});
    // Two unknowns for four areas, of which two depend on the others: areas of opposite cells add up to 2.
    EXPECT_LE(restore_areas(cells, 8, {1, 1, 1, 1}), 1e-10);
    EXPECT_NEAR(cells.points[8].x, 0, 1e-9);
    EXPECT_NEAR(cells.points[8].y, 0, 1e-9);
}

TEST(RestoredAreas, CellsAreNotTurnedInsideOut) {
    PlaneCells cells = row_of_three(1, 2);
    for (const double area : {1e-3, 1e-6}) {
        restore_areas(cells, 4, {3 - 2 * area, area, area});
        for (std::size_t cell = 0; cell < 3; ++cell) EXPECT_TRUE(is_sound(corners_of(cells, cell)));
    }
    // Nothing can move: the error is told.
    PlaneCells fixed = row_of_three(0.8, 2);
    EXPECT_NEAR(restore_areas(fixed, 8, {1, 1, 1}), 0.2, 1e-12);
    EXPECT_EQ(fixed.points, row_of_three(0.8, 2).points);
}

}  // namespace
}  // namespace graincrack::mesher
