#include "mesher/plane/power_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace graincrack::mesher {
namespace {

TEST(PowerDiagram, HasOneLineOfEqualPowersBetweenTwoSeeds) {
    const std::vector<Point> seeds{{-1, 0}, {1, 0}};
    for (const double weight : {0.0, 0.8, -1.2}) {
        const PowerDiagram diagram = power_diagram(seeds, std::vector{weight, 0.0}, 3);
        ASSERT_EQ(diagram.sides.size(), 1U);
        const PowerDiagram::Side side = diagram.sides.front();
        const Point from = diagram.vertices[index(side.from)];
        const Point to = diagram.vertices[index(side.to)];
        // (x + 1)² − w = (x − 1)²
        EXPECT_NEAR(from.x, weight / 4, 1e-12);
        EXPECT_NEAR(to.x, weight / 4, 1e-12);
        EXPECT_GT(std::abs(from.y - to.y), 6) << "beyond the circle";
        // On the left of the side, where its direction says.
        EXPECT_EQ(side.left, to.y > from.y ? 0 : 1);
        EXPECT_EQ(side.left + side.right, 1);
    }
}

TEST(PowerDiagram, HasNoSidesOfEmptyCells) {
    const std::vector<Point> seeds{{-1, 0}, {0, 0}, {1, 0.1}};
    EXPECT_EQ(power_diagram(seeds, std::vector{0.0, 0.0, 0.0}, 2).sides.size(), 2U);
    const PowerDiagram diagram = power_diagram(seeds, std::vector{0.0, -3.0, 0.0}, 2);
    ASSERT_EQ(diagram.sides.size(), 1U);
    EXPECT_EQ(std::max(diagram.sides[0].left, diagram.sides[0].right), 2);
    EXPECT_EQ(std::min(diagram.sides[0].left, diagram.sides[0].right), 0);
}

}  // namespace
}  // namespace graincrack::mesher
