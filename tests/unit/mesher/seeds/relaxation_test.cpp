#include "mesher/seeds/relaxation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/region/shapes.hpp"
#include "mesher/seeds/fixed_seeds.hpp"
#include "mesher/seeds/sampling.hpp"

namespace graincrack::mesher {
namespace {

const Region tall_region = rectangle(0.08, 0.16);

constexpr double grain_edge = 8e-3;

/// A relaxed rectangle.
Seeds relaxed(std::uint64_t seed) {
    RandomNumbers random(seed);
    const DepthGrid depth(tall_region, 0.7 * grain_edge);
    const Seeds fixed = fixed_seeds(tall_region, 60, grain_edge, 0.07, random);
    const auto inner = sample_points(tall_region, depth, 0.77 * grain_edge, 0.7 * grain_edge, random);
    return relax_points(depth, fixed, inner, {grain_edge, 0.1, 200});
}

TEST(PointRelaxation, LeavesTheOutlineAlone) {
    const Seeds mesh = relaxed(2);
    RandomNumbers random(2);
    const Seeds fixed = fixed_seeds(tall_region, 60, grain_edge, 0.07, random);
    EXPECT_TRUE(std::equal(fixed.points.begin(), fixed.points.end(), mesh.points.begin()));
    for (std::size_t i = fixed.n_fixed; i < mesh.points.size(); ++i) EXPECT_GT(depth_inside(tall_region, mesh.points[i]), 2e-3);
}

TEST(PointRelaxation, GivesCornersTwoGrains) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Seeds mesh = relaxed(seed);
        ASSERT_EQ(mesh.corners.size(), 4U);
        for (const auto& [before, corner, after] : mesh.corners) {
            const auto n = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [at = corner](const Triangle& t) {
                return std::find(t.begin(), t.end(), at) != t.end();
            });
            EXPECT_GE(n, 2) << "an ear, seed " << seed;
        }
        for (const Edge& e : mesh.edges) {
            EXPECT_LT(length(mesh.points[index(e[1])] - mesh.points[index(e[0])]), 1.6 * grain_edge) << seed;
        }
    }
}

}  // namespace
}  // namespace graincrack::mesher
