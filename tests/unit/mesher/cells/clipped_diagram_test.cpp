#include "mesher/cells/clipped_diagram.hpp"

#include <gtest/gtest.h>

#include "mesher/cells/polygon.hpp"
#include "mesher/cells/walls.hpp"
#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

TEST(ClippedDiagram, CutsTheCornersOfARectangle) {
    const ConvexOutline outline = walls_of(rectangle(4, 2), 1).hull;
    const std::vector<Point> seeds{{-1, 0}, {1, 0}};
    const ClippedDiagram diagram(outline, seeds, std::vector{0.4, 0.0});
    ASSERT_TRUE(diagram.is_consistent());
    // They meet at x = 0.1.
    EXPECT_NEAR(diagram.areas()[0], 4.2, 1e-12);
    EXPECT_NEAR(diagram.areas()[1], 3.8, 1e-12);
    EXPECT_NEAR(diagram.centroids()[0].x, -0.95, 1e-12);
    EXPECT_NEAR(diagram.centroids()[1].x, 1.05, 1e-12);
    const PlaneCells cells = diagram.cells();
    ASSERT_EQ(cells.size(), 2U);
    EXPECT_EQ(cells.points.size(), 6U);
    EXPECT_EQ(cells.edges.size(), 7U);
    EXPECT_EQ(cells.sides.size(), 6U);
    EXPECT_EQ(cells.loop(0).size(), 4U);
    for (const Side& side : cells.sides) {
        const Point middle = midpoint(cells.points[index(side.from)], cells.points[index(side.to)]);
        EXPECT_EQ(side.part, middle.y == -1 ? 0 : middle.x == 2 ? 1 : middle.y == 1 ? 2 : 3);
    }
}

TEST(ClippedDiagram, IsTheOutlineForOneCell) {
    const ConvexOutline outline = walls_of(half_disc(2), 0.3).hull;
    const ClippedDiagram diagram(outline, std::vector<Point>{{0, 0}}, std::vector{0.0});
    EXPECT_NEAR(diagram.areas()[0], moments(outline.corners).area, 1e-12);
    EXPECT_EQ(diagram.cells().loop(0).size(), outline.size());
}

TEST(ClippedDiagram, LeavesSidesWithoutCellsToTheEnds) {
    const ConvexOutline outline = walls_of(rectangle(4, 2), 1).hull;
    // The three lines between cells end on the lower side alone, or on the upper one.
    const std::vector<Point> seeds{{0, 0.9}, {-0.2, -0.95}, {0.2, -0.95}};
    const ClippedDiagram diagram(outline, seeds, std::vector{2.9, 0.0, 0.0});
    ASSERT_TRUE(diagram.is_consistent());
    EXPECT_NEAR(diagram.areas()[0] + diagram.areas()[1] + diagram.areas()[2], 8, 1e-12);
    EXPECT_NEAR(diagram.areas()[1], diagram.areas()[2], 1e-12);
    EXPECT_GT(diagram.areas()[0], 0);
}

}  // namespace
}  // namespace graincrack::mesher
