#include "mesher/cells/walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "mesher/cells/polygon.hpp"
#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/region/test_regions.hpp"

namespace graincrack::mesher {
namespace {

double area_inside(const Zones& zones) {
    double sum = 0;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) sum += zones.is_inside(zone) ? zones.area(zone) : 0;
    return sum;
}

TEST(Walls, HaveTheEndsOfASlitAndTheOutlineAsHull) {
    Region region = rectangle(4, 2);
    region.edges = {slit_from_below(region, 1, "slit")};
    const Walls walls = walls_of(region, 0.1);
    EXPECT_TRUE(walls.is_convex);
    EXPECT_EQ(walls.hull.size(), 4U);
    ASSERT_EQ(walls.sides.size(), 6U);  // the bottom is divided where the slit begins
    EXPECT_EQ(walls.sides.back().part, -1);
    EXPECT_EQ(walls.at(walls.sides.back().to), (Point{0, 0}));
    const Zones zones(walls);
    EXPECT_EQ(zones.size(), 1U);  // which the slit does not divide
    EXPECT_NEAR(zones.area(0), 8, 1e-12);
}

TEST(Walls, HaveABoxAroundAnLWithHoles) {
    const Walls walls = walls_of(l_with_holes(), 0.004);
    EXPECT_FALSE(walls.is_convex);
    EXPECT_FALSE(walls.contains({0.06, 0.06}));
    EXPECT_FALSE(walls.contains({0.06, 0.02}));
    EXPECT_TRUE(walls.contains({0.005, 0.005}));
    const Zones zones(walls);
    EXPECT_EQ(zones.size(), 4U);  // inside, outside and two holes
    EXPECT_NEAR(area_inside(zones) / area_of_l, 1, 1e-9);
}

// The integral of one over (.5 + 1.5 t)² along the height is (1/.5 − 1/1.25)/1.5 in the lower half and (1/1.25 − 1/2)/1.5 in the
// upper one; tabulated sizes are scaled so that both together are the area, and are linear between points of the table.
TEST(Zones, HaveRoomForGradedCells) {
    Region region = rectangle(4, 4);
    region.edges = {{{-2, 0}, {2, 0}, {}, "joint"}};
    const SizeField size(region, 0.1, parse_grading("along=y,from=0.5,to=2", "--grade"), {}, 0);
    const Zones zones(walls_of(region, 0.1, {}, size));
    ASSERT_EQ(zones.size(), 2U);
    std::vector<double> room{zones.graded_area(0, size), zones.graded_area(1, size)};
    std::sort(room.begin(), room.end());
    EXPECT_NEAR(room[0] / 16, 0.2, 0.2 * 0.02);
    EXPECT_NEAR(room[1] / 16, 0.8, 0.8 * 0.02);
    EXPECT_EQ(zones.graded_area(0, {}), zones.area(0));
}

TEST(Zones, KeepTheirSeeds) {
    Region region = rectangle(4, 2);
    region.edges = {central_slit(region, 2, 1.5707963267948966, "joint")};  // divides it
    const Walls walls = walls_of(region, 0.1);
    const Zones zones(walls);
    ASSERT_EQ(zones.size(), 2U);
    RandomNumbers random(1);
    for (std::size_t zone = 0; zone < 2; ++zone) {
        const double side = zones.random_point(zone, random).x;
        for (int i = 0; i < 100; ++i) EXPECT_GT(zones.random_point(zone, random).x * side, 0);
    }
    EXPECT_EQ(zones.moved({-1, 0}, {1, 0}, 0.3), (Point{-1, 0}));        // not across
    EXPECT_NEAR(zones.moved({-1, 0}, {-0.1, 0.2}, 0.3).x, -0.3, 1e-12);  // away from the joint
    EXPECT_EQ(zones.moved({-1, 0}, {-0.5, 0.2}, 0.3), (Point{-0.5, 0.2}));
}

TEST(Walls, HaveStraightSidesWhole) {
    const ConvexOutline outline = walls_of(rectangle(4, 2), 0.1).hull;
    EXPECT_EQ(outline.corners, (std::vector<Point>{{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}));
    EXPECT_EQ(outline.parts, (std::vector<std::uint8_t>{0, 1, 2, 3}));
    EXPECT_DOUBLE_EQ(moments(outline.corners).area, 8);
    EXPECT_NEAR(length(moments(outline.corners).centroid), 0, 1e-15);
}

TEST(Walls, HaveTheAreaAndFacetsOfADisc) {
    const ConvexOutline outline = walls_of(disc(0.08), 0.004).hull;
    EXPECT_NEAR(moments(outline.corners).area / (std::numbers::pi * 0.0016), 1, 1e-9);
    EXPECT_NEAR(static_cast<double>(outline.size()), std::numbers::pi * 20, 2);
    const double arc = walls_of(disc(0.08), 0.004).loading_arc;
    EXPECT_NEAR(arc, 2 * std::numbers::pi / static_cast<double>(outline.size()), 0.01 * arc);
    int facets = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (std::abs(outline.corner(i).y) != 0.04 || outline.corner(i).y != outline.corner(i + 1).y) continue;
        ++facets;
        EXPECT_NEAR(2 * std::atan2(length(outline.corner(i + 1) - outline.corner(i)) / 2, 0.04), arc, 1e-9);
    }
    EXPECT_EQ(facets, 2);
    EXPECT_GE(walls_of(disc(0.08), 0.05).hull.size(), 24U);
}

TEST(Walls, HaveTheAreasOfArcsAndOfElongatedCells) {
    for (const Region& region : {disc_with_flats(0.08, 0.3), half_disc(0.08)}) {
        EXPECT_NEAR(moments(walls_of(region, 0.004).hull.corners).area / area(region), 1, 1e-9);
    }
    EXPECT_EQ(walls_of(half_disc(0.08), 0.004).hull.parts.front(), 0);
    const Zones zones(walls_of(ring(0.08, 0.03), 0.004, Stretch({2, 0.5})));
    EXPECT_NEAR(area_inside(zones) / area(ring(0.08, 0.03)), 1, 1e-9);
}

}  // namespace
}  // namespace graincrack::mesher
