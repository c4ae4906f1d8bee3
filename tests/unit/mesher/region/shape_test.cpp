#include "mesher/region/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graincrack::mesher {
namespace {

TEST(Shape, HasTheRegionOfItsKind) {
    EXPECT_EQ(region_of({ShapeKind::rectangle, 0.08, 0.16, Pole::facet}).name, "rectangle");
    const Region round = region_of({ShapeKind::disc, 0.08, 0.08, Pole::facet, 6, 2});
    EXPECT_TRUE(is_round(round));
    EXPECT_EQ(round.loops[0].circle->diameters, 6);
}

TEST(Shape, TheLoadedDiameterComesToLieAlongY) {
    const double angle = 3.14159265358979323846 * (0.5 + 2.0 / 6);
    std::vector<Point> points{{0.04 * std::cos(angle), 0.04 * std::sin(angle)}, {0.01, 0}};
    turn_to_load({ShapeKind::disc, 0.08, 0.08, Pole::vertex, 6, 2}, points);
    EXPECT_NEAR(points[0].x, 0, 1e-16);
    EXPECT_EQ(points[0].y, 0.04);
    EXPECT_NEAR(length(points[1]), 0.01, 1e-16);
}

}  // namespace
}  // namespace graincrack::mesher
