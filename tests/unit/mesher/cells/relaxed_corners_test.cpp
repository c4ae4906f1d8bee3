#include "mesher/cells/relaxed_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesher/cells/polygon.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/plane/step_length.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

/// Shape of cells: shortest edge over the root of the area of a cell beside it, what one in fifty of the triangles between sides
/// and the middle of their cell falls below in step length over that root, and corners a cell.
struct Shape {
    double shortest = INFINITY;
    double step = 0, n_corners = 0;
};

Shape shape_of(const PlaneCells& cells) {
    Shape shape;
    std::vector<double> steps;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const std::vector<Point> corners = corners_of(cells, cell);
        const double root = std::sqrt(area_of(corners));
        const auto n = static_cast<double>(corners.size());
        shape.n_corners += n / static_cast<double>(cells.size());
        Point middle;
        for (const Point p : corners) middle = middle + (1 / n) * p;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point next = corners[(i + 1) % corners.size()];
            shape.shortest = std::min(shape.shortest, length(next - corners[i]) / root);
            steps.push_back(step_length(middle, corners[i], next) / root);
        }
    }
    std::sort(steps.begin(), steps.end());
    shape.step = steps[steps.size() / 50];
    return shape;
}

TEST(RelaxedCorners, MakeShapesBetterAndKeepAreas) {
    for (const Region& region : {rectangle(0.08, 0.16), disc(0.08)}) {
        for (const double spread : {0.1, 0.3}) {
            const RandomCells m(region, 500, spread, SizeDistribution::normal, 3);
            const auto& [outline, requested, made] = m;
            PlaneCells cells = made.cells;
            remove_short_edges(cells, outline.size());
            ASSERT_LE(restore_areas(cells, outline.size(), requested), 1e-6);
            const PlaneCells before = cells;
            EXPECT_LE(relax_corners(cells, outline.size(), requested), 1e-6);
            const std::vector<double> areas = areas_of(cells);
            for (std::size_t cell = 0; cell < cells.size(); ++cell) {
                EXPECT_NEAR(areas[cell] / requested[cell], 1, 1e-6);
                EXPECT_TRUE(is_sound(corners_of(cells, cell)));
            }
            EXPECT_GT(shape_of(cells).shortest, shape_of(before).shortest);
            EXPECT_GT(shape_of(cells).step, 1.05 * shape_of(before).step);
            EXPECT_NEAR(shape_of(cells).n_corners, 5.5, 0.4) << "as of hexagons, of which some have lost a short edge";
            EXPECT_EQ(cells.corners, before.corners);
            for (std::size_t p = 0; p < outline.size(); ++p) EXPECT_EQ(cells.points[p], before.points[p]);
            for (const auto& [from, to, part, kind] : cells.sides) {
                const Point is = cells.points[index(to)] - cells.points[index(from)];
                const Point was = before.points[index(to)] - before.points[index(from)];
                EXPECT_NEAR(cross(unit(is), unit(was)), 0, 1e-12);
            }
        }
    }
}

TEST(RelaxedCorners, LeaveFixedPoints) {
    // Two halves of a square, all of whose points are fixed.
    PlaneCells cells = halves_of_square();
    EXPECT_NEAR(relax_corners(cells, 6, {2, 2}), 0, 1e-12);
    EXPECT_EQ(cells.points, halves_of_square().points);
}

/// A rectangle of 3 × 1 in three cells of a row; corners of the rectangle are the first points.
PlaneCells row_of_three(double first, double second) {
    return cells_of(
        {{0, 0}, {3, 0}, {3, 1}, {0, 1}, {first, 0}, {first, 1}, {second, 0}, {second, 1}},
        {{0, 4, 5, 3}, {4, 6, 7, 5}, {6, 1, 2, 7}},
        {{0, 4, 0, {}}, {4, 6, 0, {}}, {6, 1, 0, {}}, {1, 2, 1, {}}, {2, 7, 2, {}}, {7, 5, 2, {}}, {5, 3, 2, {}}, {3, 0, 3, {}}});
}

TEST(RestoredAreas, MoveWallsAlongTheBoundary) {
    PlaneCells cells = row_of_three(0.8, 2.1);
    EXPECT_LE(restore_areas(cells, 4, {1, 1, 1}), 1e-10);
    // The shortest moves are those of both ends of a wall alike.
    const PlaneCells expected = row_of_three(1, 2);
    for (std::size_t p = 0; p < cells.points.size(); ++p) {
        EXPECT_NEAR(cells.points[p].x, expected.points[p].x, 1e-9);
        EXPECT_EQ(cells.points[p].y, expected.points[p].y);
    }
}

TEST(RestoredAreas, MoveInnerPointsFreely) {
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

TEST(RestoredAreas, TurnNoCellInsideOut) {
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
