#include "mesher/region/depth_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/plane/random_numbers.hpp"
#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/region/test_regions.hpp"

namespace graincrack::mesher {
namespace {

/// Depth without a grid, prescribed edges included.
double depth_of(const Region& region, Point p) {
    double depth = depth_inside(region, p);
    for (const Curve& curve : curves_of(region)) depth = std::min(depth, curve.distance(p));
    return depth;
}

TEST(DepthGrid, AnswersAsWithoutIt) {
    Region region = l_with_holes();
    region.edges = {{{0.03, 0.01}, {0.035, 0.07}}};
    for (const double reach : {0.0005, 0.003, 0.02}) {
        const DepthGrid grid(region, reach);
        RandomNumbers random(1);
        int n_deep = 0;
        for (int i = 0; i < 20000; ++i) {
            const Point p{0.04 + 0.05 * random.symmetric(), 0.04 + 0.05 * random.symmetric()};
            const double depth = reach * random.uniform();
            ASSERT_EQ(grid.is_deep(p, depth), depth_of(region, p) >= depth) << p.x << ' ' << p.y;
            n_deep += grid.is_deep(p, depth) ? 1 : 0;
        }
        EXPECT_GT(n_deep, 500);
    }
}

TEST(DepthGrid, MovesPointsInside) {
    Region region = l_with_holes();
    region.edges = {{{0.03, 0.025}, {0.03, 0.07}}};
    const DepthGrid grid(region, 0.003);
    const Point before{0.005, 0.005};
    const auto kept = [&](Point p) { return grid.kept_deep(p, 0.002, before); };
    EXPECT_EQ(kept({0.03, 0.015}), (Point{0.03, 0.015})) << "deep enough";
    EXPECT_EQ(kept({0.05, 0.001}), (Point{0.05, 0.002}));
    EXPECT_EQ(kept({0.05, -0.001}), (Point{0.05, 0.002})) << "from outside";
    EXPECT_EQ(kept({0.001, 0.0005}), (Point{0.002, 0.002})) << "in a corner";
    EXPECT_NEAR(length(kept({0.041, 0.042}) - Point{0.04, 0.04}), 0.002, 0.0021) << "around the corner that points inwards";
    EXPECT_NEAR(kept({0.0295, 0.05}).x, 0.028, 1e-15) << "it stays on its side of a prescribed edge";
    EXPECT_NEAR(kept({0.0305, 0.05}).x, 0.032, 1e-15);
    RandomNumbers random(2);
    for (int i = 0; i < 2000; ++i) {
        const Point p = kept({0.04 + 0.042 * random.symmetric(), 0.04 + 0.042 * random.symmetric()});
        ASSERT_TRUE(grid.is_deep(p, 0.00099)) << p.x << ' ' << p.y;
    }
    const Region thin = rectangle(0.003, 0.1);
    EXPECT_EQ(DepthGrid(thin, 0.005).kept_deep({0.0001, 0}, 0.004, {0, 0.001}), (Point{0, 0.001})) << "no room";
}

}  // namespace
}  // namespace graincrack::mesher
