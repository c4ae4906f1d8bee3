#include "mesher/cells/convex_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

TEST(ConvexOutline, HasStraightSidesWhole) {
    const ConvexOutline outline = convex_outline(rectangle(4, 2), 0.1);
    EXPECT_EQ(outline.corners, (std::vector<Point>{{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}));
    EXPECT_EQ(outline.parts, (std::vector<std::uint8_t>{0, 1, 2, 3}));
    EXPECT_DOUBLE_EQ(moments(outline.corners).area, 8);
    EXPECT_NEAR(length(moments(outline.corners).centroid), 0, 1e-15);
}

TEST(ConvexOutline, OfADiscHasItsAreaAndFacets) {
    const ConvexOutline outline = convex_outline(disc(0.08), 0.004);
    EXPECT_NEAR(moments(outline.corners).area / (std::numbers::pi * 0.0016), 1, 1e-9);
    EXPECT_NEAR(static_cast<double>(outline.size()), std::numbers::pi * 20, 2);
    int facets = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (std::abs(outline.corner(i).y) == 0.04 && outline.corner(i).y == outline.corner(i + 1).y) ++facets;
    }
    EXPECT_EQ(facets, 2);
    EXPECT_NEAR(outline.loading_arc, 2 * std::numbers::pi / static_cast<double>(outline.size()), 0.01 * outline.loading_arc);
    EXPECT_GE(convex_outline(disc(0.08), 0.05).size(), 24U);
}

TEST(ConvexOutline, OfFlatsAndHalvesHasArcs) {
    const ConvexOutline flats = convex_outline(disc_with_flats(0.08, 0.3), 0.004);
    EXPECT_NEAR(moments(flats.corners).area / area(disc_with_flats(0.08, 0.3)), 1, 1e-9);
    const ConvexOutline half = convex_outline(half_disc(0.08), 0.004);
    EXPECT_NEAR(moments(half.corners).area / area(half_disc(0.08)), 1, 1e-9);
    EXPECT_EQ(half.parts.front(), 0);
}

}  // namespace
}  // namespace graincrack::mesher
