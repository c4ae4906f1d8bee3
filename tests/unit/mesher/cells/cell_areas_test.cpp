#include "mesher/cells/cell_areas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/region/shapes.hpp"

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
        double squares = 0, cubes = 0;
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

const SizeField graded_size(rectangle(4, 4), 0.1, parse_grading("along=y,from=0.5,to=2", "--grade"), {}, 0);

TEST(GradedAreas, AreThoseDrawnWhereSizesAreEqual) {
    EXPECT_FALSE(GradedAreas({1, 2}).are_graded());
    const SizeField uniform;
    EXPECT_EQ(GradedAreas({1, 2}, uniform).at({{0, -2}, {0, 2}}), (std::vector<double>{1, 2}));
}

TEST(GradedAreas, GrowWithTheSquareOfTheSizeAndFillTheirParts) {
    const Point low{0, -2};
    const Point high{0, 2};  // where the size is four times as large
    const auto whole = GradedAreas({1, 2}, graded_size).at({low, high});
    EXPECT_NEAR(whole[0], 3.0 / 33, 1e-9);
    EXPECT_NEAR(whole[1], 3.0 * 32 / 33, 1e-9);
    const auto parts = GradedAreas({1, 2, 5}, graded_size, {0, 0, 1}).at({low, high, high});
    EXPECT_NEAR(parts[0] + parts[1], 3, 1e-12);
    EXPECT_NEAR(parts[1] / parts[0], 32, 1e-9);
    EXPECT_NEAR(parts[2], 5, 1e-12);
}

// Density is 1/g²: of places along a line on which g grows from .5 to 2 the lower half has (1/.5 − 1/1.25)/(1/.5 − 1/2) = .8.
// The tolerance is three standard deviations of 4000 draws, 3 √(.8 · .2/4000) = .019.
TEST(GradedAreas, HaveDenserPlacesWhereCellsAreSmall) {
    RandomNumbers random(1);
    const GradedAreas areas({1}, graded_size);
    int n_low = 0;
    for (int i = 0; i < 4000; ++i) {
        n_low += areas.random_place([&] { return Point{0, -2 + 4 * random.uniform()}; }, random).y < 0 ? 1 : 0;
    }
    EXPECT_NEAR(n_low / 4000.0, 0.8, 0.019);
}

}  // namespace
}  // namespace graincrack::mesher
