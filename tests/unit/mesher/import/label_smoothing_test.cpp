#include "mesher/import/label_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace graincrack::mesher {
namespace {

/// A chain in steps of pixels near a line from (0, 0) with a slope below 1.
BoundaryChain staircase(int n, double slope) {
    BoundaryChain chain{0, 1, 0, 1, {{0, 0}}};
    double y = 0;
    for (int x = 0; x < n; ++x) {
        const double next = std::floor(slope * (x + 0.5) + 0.5);
        if (next != y) chain.path.push_back({static_cast<double>(x), y = next});
        chain.path.push_back({x + 1.0, y});
    }
    return chain;
}

TEST(SmoothChain, OfAStraightBoundaryIsStraight) {
    for (const double slope : {0.0, 0.15, 0.37, 0.5, 0.8}) {
        const BoundaryChain chain = staircase(60, slope);
        const Point end = chain.path.back();
        const SmoothChain smooth(chain, {0, 0}, end, 12);
        EXPECT_EQ(smooth.point(0), (Point{0, 0}));
        EXPECT_EQ(smooth.point(smooth.size() - 1), end);
        for (std::size_t i = 0; i < smooth.size(); ++i) {
            // Its ends are corners of pixels, up to half a pixel from the line.
            EXPECT_LT(std::abs(cross(smooth.point(i), unit(end))), 0.35) << slope << ": " << i;
        }
    }
}

TEST(SmoothChain, HasSegmentsOfAboutTheSpacing) {
    const BoundaryChain chain = staircase(60, 0.37);
    for (const double spacing : {2.0, 5.0, 12.0}) {
        const SmoothChain smooth(chain, chain.path.front(), chain.path.back(), spacing);
        EXPECT_NEAR(static_cast<double>(smooth.n_segments()), length(chain.path.back()) / spacing, 1);
        const double even = length(chain.path.back()) / static_cast<double>(smooth.n_segments());
        for (std::size_t i = 0; i < smooth.n_segments(); ++i) {
            // Points are those at the middles of sides of pixels, up to a pixel apart.
            EXPECT_NEAR(length(smooth.point(i + 1) - smooth.point(i)), even, 1);
        }
    }
    EXPECT_EQ(SmoothChain(chain, chain.path.front(), chain.path.back(), 1000).n_segments(), 1U);
}

TEST(SmoothChain, KeepsTheAreaThatItEncloses) {
    for (const int side : {1, 3, 8, 30}) {
        BoundaryChain square{-1, -1, 0, 1, {}};
        for (int k = 0; k < 4; ++k) {
            constexpr Point corner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
            for (int i = 0; i < side; ++i) {
                square.path.push_back(static_cast<double>(side) * corner[k] +
                                      static_cast<double>(i) * (corner[(k + 1) % 4] - corner[k]));
            }
        }
        const SmoothChain smooth(square, {}, {}, side / 3.0);
        EXPECT_GE(smooth.size(), side == 1 ? 4U : 6U);
        double area = 0;
        for (std::size_t i = 0; i < smooth.size(); ++i) {
            area += 0.5 * cross(smooth.point(i), smooth.point((i + 1) % smooth.size()));
        }
        EXPECT_NEAR(area, side * side, 0.01 * side * side) << side;
    }
}

TEST(SmoothChain, IsRefinedDownToTheSidesOfPixels) {
    const BoundaryChain chain = staircase(20, 0.5);
    SmoothChain smooth(chain, chain.path.front(), chain.path.back(), 10);
    ASSERT_EQ(smooth.n_segments(), 2U);
    ASSERT_TRUE(smooth.refine({1}));
    EXPECT_EQ(smooth.n_segments(), 3U);
    const auto all = [&] {
        std::vector<std::size_t> segments;
        for (std::size_t i = 0; i < smooth.n_segments(); ++i) segments.push_back(i);
        return segments;
    };
    int rounds = 0;
    while (smooth.refine(all())) ASSERT_LT(++rounds, 20);
    ASSERT_EQ(smooth.size(), chain.path.size() + 1);
    for (std::size_t i = 1; i + 1 < smooth.size(); ++i) EXPECT_EQ(smooth.point(i), midpoint(chain.path[i - 1], chain.path[i]));
}

}  // namespace
}  // namespace graincrack::mesher
