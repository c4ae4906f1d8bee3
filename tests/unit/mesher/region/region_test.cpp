#include "mesher/region/region.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/region/test_regions.hpp"

namespace graincrack::mesher {
namespace {

TEST(Region, HasItsMeasures) {
    EXPECT_EQ(area(rectangle(0.08, 0.16)), 0.08 * 0.16);
    EXPECT_DOUBLE_EQ(perimeter(rectangle(0.08, 0.16)), 0.48);
    EXPECT_DOUBLE_EQ(area(disc(0.08, Pole::facet, 1)), 3.14159265358979323846 * 0.0016);
    const Region l = l_with_holes();
    EXPECT_NEAR(area(l), area_of_l, 1e-17);
    EXPECT_NEAR(perimeter(l), 0.32 + 0.04 + 2 * 3.14159265358979 * 0.008, 1e-12);
    EXPECT_EQ(bounds(l).width(), 0.08);
    EXPECT_TRUE(is_plain(rectangle(1, 2)) && is_plain(disc(1, Pole::vertex, 1)) && !is_plain(l));
}

TEST(Region, IsDeepInside) {
    EXPECT_DOUBLE_EQ(depth_inside(rectangle(0.08, 0.16), {0.03, 0}), 0.01);
    EXPECT_LT(depth_inside(rectangle(0.08, 0.16), {0, 0.09}), 0);
    EXPECT_DOUBLE_EQ(depth_inside(disc(0.08, Pole::facet, 1), {0, 0.03}), 0.01);
    const Region l = l_with_holes();
    EXPECT_NEAR(depth_inside(l, {0.037, 0.036}), 0.005, 1e-15) << "from the corner that points inwards";
    EXPECT_NEAR(depth_inside(l, {0.043, 0.044}), -0.003, 1e-15);
    EXPECT_NEAR(depth_inside(l, {0.015, 0.013}), -0.003, 1e-15) << "in the square hole";
    EXPECT_NEAR(depth_inside(l, {0.06, 0.017}), -0.005, 1e-15) << "in the round hole";
    EXPECT_NEAR(depth_inside(l, {0.06, 0.031}), 0.003, 1e-15) << "above it";
}

TEST(Region, ClipsAnEdgeToWhatLiesInside) {
    const Region l = l_with_holes();
    const auto pieces = clip(l, {{-0.01, 0.015}, {0.1, 0.015}, ContactKind::pre_existing_crack});
    ASSERT_EQ(pieces.size(), 3U) << "left of the square hole, between the holes, right of the round hole";
    const double half = std::sqrt(0.008 * 0.008 - 0.005 * 0.005);
    const std::array<double, 6> ends{0, 0.01, 0.02, 0.06 - half, 0.06 + half, 0.08};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(pieces[i].from.x, ends[2 * i], 1e-16);
        EXPECT_NEAR(pieces[i].to.x, ends[2 * i + 1], 1e-16);
        EXPECT_EQ(pieces[i].kind, ContactKind::pre_existing_crack);
    }
    const auto inside = clip(l, {{0.03, 0.01}, {0.035, 0.03}});
    ASSERT_EQ(inside.size(), 1U);
    EXPECT_EQ(inside[0].to, (Point{0.035, 0.03}));
    EXPECT_TRUE(clip(l, {{0.05, 0.05}, {0.07, 0.07}}).empty()) << "outside";
    EXPECT_TRUE(clip(l, {{0.01, 0}, {0.03, 0}}).empty()) << "along a side";
}

TEST(StretchedRegion, KeepsAreasAndReturns) {
    const Stretch stretch({3, 0.5});
    const Point axis{std::cos(0.5), std::sin(0.5)};
    EXPECT_NEAR(length(stretch.elongated(axis)), std::sqrt(3), 1e-14);
    EXPECT_NEAR(length(stretch.elongated(left_of(axis))), 1 / std::sqrt(3), 1e-14);
    EXPECT_NEAR(length(stretch.elongated(stretch.equiaxed({1, 2})) - Point{1, 2}), 0, 1e-14);
    const Point exact = Stretch({1, 0.7}).equiaxed({0.1, 0.3});
    EXPECT_EQ(exact, (Point{0.1, 0.3}));
    EXPECT_NEAR(area(stretched(rectangle(2, 3), stretch, 0.1)) / 6, 1, 1e-14);
    for (const Region& region : {disc(2), ring(2, 1), half_disc(2), disc_with_flats(2, 0.4)}) {
        const Region image = stretched(region, stretch, 0.02);
        EXPECT_NEAR(area(image) / area(region), 1, 1e-3) << region.name;  // sides of 0.02 on radii of 1 and 0.5
    }
    EXPECT_TRUE(is_round(stretched(disc(2), {}, 0.1))) << "as it is without elongation";
}

}  // namespace
}  // namespace graincrack::mesher
