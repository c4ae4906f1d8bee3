#include "mesher/seeds/fixed_seeds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {
namespace {

const Region upright = rectangle(0.08, 0.16);
const Region facet_disc = disc(0.08, Pole::facet, 1);
const Region vertex_disc = disc(0.08, Pole::vertex, 1);

TEST(FixedSeeds, HaveTheParityAskedFor) {
    EXPECT_EQ(admissible_boundary_count(upright, 92.9, false), 92);
    EXPECT_EQ(admissible_boundary_count(upright, 92.9, true), 93);
    EXPECT_EQ(admissible_boundary_count(facet_disc, 1.0, false), 4);
    EXPECT_EQ(admissible_boundary_count(facet_disc, 1.0, true), 5);
}

TEST(FixedSeeds, KeepCornersSidesAndPartsOfARectangle) {
    RandomNumbers random(1);
    const Seeds outline = fixed_seeds(upright, 92, 5e-3, 0.1, random);
    ASSERT_EQ(outline.points.size(), 92U);
    ASSERT_EQ(outline.corners.size(), 4U);
    EXPECT_EQ(outline.points[index(outline.corners[2].at)], (Point{0.04, 0.08}));
    EXPECT_NEAR(area_of(outline.points), area(upright), 1e-16);
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const Point middle = midpoint(outline.points[i], outline.points[(i + 1) % outline.points.size()]);
        // Exactly on its side, as the triangulation requires.
        const std::array<double, 4> beyond{middle.y + 0.08, middle.x - 0.04, middle.y - 0.08, middle.x + 0.04};
        EXPECT_EQ(beyond.at(index(outline.sides[i].part)), 0);
    }
    const auto n_sides = [&](BoundaryPart part) {
        return std::ranges::count_if(outline.sides, [&](const Side& side) { return side.part == static_cast<int>(part); });
    };
    EXPECT_EQ(n_sides(BoundaryPart::bottom), 15);
    EXPECT_EQ(n_sides(BoundaryPart::right), 31);
}

TEST(FixedSeeds, HaveTheAreaOfADiscAndTouchThePlatens) {
    for (const Region& region : {facet_disc, vertex_disc}) {
        for (const int n : {8, 49, 50, 51, 52}) {
            RandomNumbers random(3);
            const Seeds outline = fixed_seeds(region, n, 5e-3, 0.07, random);
            ASSERT_EQ(outline.points.size(), static_cast<std::size_t>(n));
            EXPECT_TRUE(is_convex(outline.points)) << n;
            EXPECT_NEAR(area_of(outline.points) / area(region), 1, 1e-13) << n;
            const int requested = region.loops[0].circle->pole == Pole::facet ? 2 : 1;
            for (const double y : {0.04, -0.04}) {
                EXPECT_EQ(std::ranges::count_if(outline.points, [&](Point p) { return p.y == y; }), requested) << n;
            }
            for (const Point p : outline.points) EXPECT_LE(std::abs(p.y), 0.04) << n;
            for (const Side& side : outline.sides) EXPECT_EQ(side.part, static_cast<int>(BoundaryPart::rim));
        }
    }
}

TEST(FixedSeeds, KeepTheParityOfTheBoundaryBesidePrescribedEdges) {
    Region region = rectangle(0.08, 0.06);
    region.edges = {{{-0.05, 0}, {0.05, 0.001}}, {{0, -0.03}, {0, 0.01}}, {{-0.0399, -0.03}, {-0.02, 0}}};
    for (const int n : {56, 57}) {
        RandomNumbers random(1);
        const Seeds seeds = fixed_seeds(region, n, 5e-3, 0.1, random);
        int on_loops = 0;
        double boundary = 0;
        for (const Side& s : seeds.sides) {
            if (s.part < 0) continue;
            ++on_loops;
            boundary += length(seeds.points[index(s.to)] - seeds.points[index(s.from)]);
        }
        EXPECT_EQ(on_loops % 2, n % 2);
        EXPECT_GE(on_loops, n);
        EXPECT_LE(on_loops, n + 2);
        EXPECT_NEAR(boundary, 0.28, 1e-15);
        EXPECT_EQ(seeds.n_fixed, seeds.points.size());
    }
    region.edges = {{{-0.02, 0}, {0.01, 0.01}}, {{-0.005, 0.005}, {0.025, 0.015}}};
    RandomNumbers random(1);
    EXPECT_THROW(fixed_seeds(region, 56, 5e-3, 0.1, random), UsageError) << "edges upon each other";
}

}  // namespace
}  // namespace graincrack::mesher
