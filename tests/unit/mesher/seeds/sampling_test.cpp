#include "mesher/seeds/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

TEST(PointSampling, KeepsItsDistances) {
    for (const Region& region : {rectangle(0.08, 0.08), disc(0.08, Pole::facet, 1)}) {
        RandomNumbers random(5);
        const auto points = sample_points(region, DepthGrid(region, 0.002), 0.003, 0.002, random);
        double nearest = 1;
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_GE(depth_inside(region, points[i]), 0.002);
            for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, length(points[i] - points[j]));
        }
        EXPECT_GE(nearest, 0.003);
        // A saturated sample fills about two thirds of a point per squared distance.
        const double inner_area = is_round(region) ? 3.1416 * 0.038 * 0.038 : 0.076 * 0.076;
        EXPECT_NEAR(static_cast<double>(points.size()) * 0.003 * 0.003 / inner_area, 0.66, 0.05);
    }
    RandomNumbers random(1);
    const Region thin = rectangle(0.01, 0.1);
    EXPECT_TRUE(sample_points(thin, DepthGrid(thin, 0.007), 0.008, 0.007, random).empty());
}

}  // namespace
}  // namespace graincrack::mesher
