#include "mesher/cells/relaxed_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/cells/walls.hpp"
#include "mesher/plane/step_length.hpp"
#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

/// Shape of cells: shortest edge over the root of the area of a cell beside it, what one in fifty of the triangles between sides
/// and the middle of their cell falls below in step length over that root, and corners a cell.
struct Shape {
    double shortest = INFINITY;
    double step = 0;
    double n_corners = 0;
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
            constexpr std::size_t n = 500;
            const ConvexOutline outline =
                walls_of(region, std::sqrt(4 * area(region) / (std::numbers::sqrt3 * static_cast<double>(n)))).hull;
            RandomNumbers random(3);
            const std::vector<double> requested =
                requested_areas(n, moments(outline.corners).area, spread, SizeDistribution::normal, random);
            PlaneCells cells = laguerre_cells(outline, requested, random).cells;
            remove_short_edges(cells, outline.size());
            ASSERT_LE(restore_areas(cells, outline.size(), requested), 1e-6);
            const PlaneCells before = cells;
            EXPECT_LE(relax_corners(cells, outline.size(), requested), 1e-6);

            const std::vector<double> areas = areas_of(cells);
            for (std::size_t cell = 0; cell < n; ++cell) {
                EXPECT_NEAR(areas[cell] / requested[cell], 1, 1e-6);
                EXPECT_TRUE(is_sound(corners_of(cells, cell)));
            }
            EXPECT_GT(shape_of(cells).shortest, shape_of(before).shortest);
            EXPECT_GT(shape_of(cells).step, 1.05 * shape_of(before).step);
            EXPECT_NEAR(shape_of(cells).n_corners, 5.5, 0.4) << "as of hexagons, of which some have lost a short edge";
            EXPECT_EQ(cells.corners, before.corners);
            for (std::size_t p = 0; p < outline.size(); ++p) EXPECT_EQ(cells.points[p], before.points[p]);
            for (const Side& side : cells.sides) {
                const auto at = [&](int p) { return cells.points[index(p)]; };
                const auto was = [&](int p) { return before.points[index(p)]; };
                EXPECT_NEAR(std::abs(cross(unit(at(side.to) - at(side.from)), unit(was(side.to) - was(side.from)))), 0, 1e-12);
            }
        }
    }
}

TEST(RelaxedCorners, FixedPointsStay) {
    // Two halves of a square, all of whose points are fixed.
    PlaneCells cells = halves_of_square();
    const std::vector<Point> before = cells.points;
    EXPECT_NEAR(relax_corners(cells, 6, {2, 2}), 0, 1e-12);
    EXPECT_EQ(cells.points, before);
}

}  // namespace
}  // namespace graincrack::mesher
