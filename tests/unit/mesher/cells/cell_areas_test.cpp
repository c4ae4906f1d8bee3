#include "mesher/cells/cell_areas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace graincrack::mesher {
namespace {

TEST(CellAreas, HaveTheirSumAndVariation) {
    for (const SizeDistribution distribution : {SizeDistribution::normal, SizeDistribution::lognormal}) {
        for (const double spread : {0.0, 0.05, 0.2, 0.4, 0.6}) {
            for (const std::size_t n : {40U, 1000U}) {
                RandomNumbers random(3);
                const auto areas = requested_areas(n, 7, spread, distribution, random);
                ASSERT_EQ(areas.size(), n);
                EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 7, 1e-12);
                EXPECT_NEAR(diameter_variation(areas), spread, 1e-9) << n;
                EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0.01 * 7 / static_cast<double>(n));
            }
        }
    }
}

TEST(CellAreas, AreOfTheirDistribution) {
    const auto skewness = [](SizeDistribution distribution, bool of_logarithms) {
        RandomNumbers random(5);
        const auto areas = requested_areas(20000, 1, 0.25, distribution, random);
        std::vector<double> values;
        for (const double area : areas) values.push_back(of_logarithms ? std::log(area) : std::sqrt(area));
        const double mean = std::accumulate(values.begin(), values.end(), 0.0) / 20000;
        double squares = 0;
        double cubes = 0;
        for (const double value : values) {
            squares += std::pow(value - mean, 2) / 20000;
            cubes += std::pow(value - mean, 3) / 20000;
        }
        return cubes / std::pow(squares, 1.5);
    };
    EXPECT_NEAR(skewness(SizeDistribution::normal, false), 0, 0.02);
    EXPECT_NEAR(skewness(SizeDistribution::lognormal, true), 0, 0.02);
    EXPECT_GT(skewness(SizeDistribution::lognormal, false), 0.5);
}

TEST(CellAreas, AreRandomAndRepeat) {
    const auto made = [](std::uint64_t seed) {
        RandomNumbers random(seed);
        return requested_areas(100, 1, 0.3, SizeDistribution::normal, random);
    };
    EXPECT_EQ(made(1), made(1));
    EXPECT_NE(made(1), made(2));
    EXPECT_FALSE(std::is_sorted(made(1).begin(), made(1).end()));
}

}  // namespace
}  // namespace graincrack::mesher
