#include "mesher/region/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mesher/seeds/fixed_seeds.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::mesher {
namespace {

constexpr double pi = 3.14159265358979323846;

TEST(Shapes, TurnTheLoadedDiameterToY) {
    const double angle = pi * (0.5 + 2.0 / 6);
    std::vector<Point> points{{0.04 * std::cos(angle), 0.04 * std::sin(angle)}, {0.01, 0}};
    turn_to_load(disc(0.08, Pole::vertex, 6, 2), points);
    EXPECT_NEAR(points[0].x, 0, 1e-16);
    EXPECT_EQ(points[0].y, 0.04);
    EXPECT_NEAR(length(points[1]), 0.01, 1e-16);
}

TEST(Shapes, HaveTheirAreaExtentAndParts) {
    const Region half = half_disc(0.08);
    const Region flats = disc_with_flats(0.08, 20 * pi / 180);
    const Region hollow = ring(0.08, 0.03);
    EXPECT_NEAR(area(half) / (pi * 0.0008), 1, 1e-14);
    EXPECT_NEAR(area(flats) / (pi * 0.0016 - 0.0016 * (20 * pi / 180 - std::sin(20 * pi / 180))), 1, 1e-14);
    EXPECT_NEAR(area(hollow) / (pi * (0.0016 - 0.000225)), 1, 1e-14);
    EXPECT_NEAR(perimeter(half), 0.08 + 0.04 * pi, 1e-15);
    EXPECT_EQ(bounds(half).high, (Point{0.04, 0.02}));
    EXPECT_EQ(bounds(half).low, (Point{-0.04, -0.02}));
    EXPECT_NEAR(bounds(flats).high.x, 0.04, 1e-17);
    EXPECT_NEAR(bounds(flats).height(), 0.08 * std::cos(10 * pi / 180), 1e-16);
    EXPECT_EQ(hollow.part_names, (std::vector<std::string>{"bottom", "right", "top", "left", "outer", "inner"}));
}

TEST(Shapes, AreAsDeepBelowAnArcAsBelowItsCircle) {
    const Region half = half_disc(0.08);
    EXPECT_NEAR(depth_inside(half, {0.02, 0}), 0.04 - std::hypot(0.02, 0.02), 1e-16);
    EXPECT_NEAR(depth_inside(half, {0, -0.015}), 0.005, 1e-16);
    EXPECT_NEAR(depth_inside(half, {0.03, 0.02}), 0.04 - 0.05, 1e-16);
    EXPECT_LT(depth_inside(half, {0, -0.021}), 0);
    const auto pieces = clip(half, {{0, -0.05}, {0.00, 0.05}});
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_NEAR(pieces[0].from.y, -0.02, 1e-16);
    EXPECT_NEAR(pieces[0].to.y, 0.02, 1e-16);
}

TEST(Shapes, HaveTheirAreaAsPolygonsThroughArcs) {
    for (const Region& region : {half_disc(0.08), disc_with_flats(0.08, 0.3)}) {
        for (const int n : {12, 40, 41}) {
            RandomNumbers random(3);
            const Seeds seeds = fixed_seeds(region, n, 5e-3, 0.07, random);
            EXPECT_NEAR(area_of(seeds.points) / area(region), 1, 1e-12) << region.name << n;
        }
    }
}

TEST(Shapes, ArePolygonsOfEitherDirection) {
    const std::vector<Point> corners{{0, 0}, {0.04, 0}, {0.04, 0.02}, {0, 0.02}};
    const Region forward = polygon(corners, {"bottom", "push", "top", ""});
    const Region backward = polygon({corners[3], corners[2], corners[1], corners[0]}, {"top", "push", "bottom", ""});
    for (const Region& region : {forward, backward}) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Point middle = midpoint(region.loops[0].corners[i], region.loops[0].corners[(i + 1) % 4]);
            const std::string name = region.part_names[region.loops[0].parts[i]];
            EXPECT_EQ(name, middle.y == 0 ? "bottom" : middle.y == 0.02 ? "top" : middle.x == 0.04 ? "push" : "side");
        }
    }
    Region moved = forward;
    EXPECT_EQ(centre_region(moved), (Point{-0.02, -0.01}));
    EXPECT_EQ(bounds(moved).low, (Point{-0.02, -0.01}));
}

TEST(Shapes, HaveRoomForHolesAndSlitsOrRefuseThem) {
    Region region = rectangle(0.08, 0.08);
    add_hole(region, {0.01, 0}, 0.01, "--hole 1");
    EXPECT_EQ(region.part_names.back(), "hole_1");
    test::Refusals refused;
    const auto add = [&](const std::string& what, Point centre, double radius) {
        Region copy = region;
        refused.add<UsageError>(what, [&] { add_hole(copy, centre, radius, "--hole 2"); });
    };
    add("a hole across the boundary", {0.035, 0}, 0.01);
    add("a hole across the other", {0.025, 0}, 0.007);
    add("a hole in the other", {0.012, 0}, 0.001);
    add("a hole outside", {0.06, 0}, 0.001);
    refused.add<UsageError>("a slit through a disc", [] { (void)central_slit(disc(0.08), 0.0801, 0, "--slit"); });
    refused.add<UsageError>("a slit through half a disc", [] { (void)slit_from_below(half_disc(0.08), 0.04, "--slit"); });
    test::expect_golden(refused.text());
    add_hole(region, {-0.02, 0}, 0.01, "--hole 2");
    EXPECT_EQ(region.part_names.back(), "hole_2");
    EXPECT_EQ(slit_from_below(half_disc(0.08), 0.02, "--slit").to, (Point{0, 0}));
    EXPECT_EQ(slit_from_below(rectangle(0.25, 0.08), 0.02, "--slit", 0.05).to, (Point{0.05, -0.02}));
}

}  // namespace
}  // namespace graincrack::mesher
