#include "mesher/cells/cell_areas.hpp"

#include <gtest/gtest.h>

#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

const Region plate_of_graded_areas = rectangle(4, 4);
const SizeField size_of_graded_areas(plate_of_graded_areas, 0.1, parse_grading("along=y,from=0.5,to=2", "--grade"), {}, 0);

TEST(GradedAreas, AreThoseDrawnWhereSizesDoNotVary) {
    EXPECT_FALSE(GradedAreas({1, 2}).are_graded());
    const SizeField uniform;
    EXPECT_EQ(GradedAreas({1, 2}, uniform).at({{0, -2}, {0, 2}}), (std::vector<double>{1, 2}));
}

TEST(GradedAreas, GrowWithTheSquareOfTheSizeAndFillTheirParts) {
    const Point low{0, -2};
    const Point high{0, 2};  // where the size is four times as large
    const auto whole = GradedAreas({1, 2}, size_of_graded_areas).at({low, high});
    EXPECT_NEAR(whole[0], 3.0 / 33, 1e-9);
    EXPECT_NEAR(whole[1], 3.0 * 32 / 33, 1e-9);
    const auto parts = GradedAreas({1, 2, 5}, size_of_graded_areas, {0, 0, 1}).at({low, high, high});
    EXPECT_NEAR(parts[0] + parts[1], 3, 1e-12);
    EXPECT_NEAR(parts[1] / parts[0], 32, 1e-9);
    EXPECT_NEAR(parts[2], 5, 1e-12);
}

// Density is 1/g²: of places along a line on which g grows from .5 to 2 the lower half has (1/.5 − 1/1.25)/(1/.5 − 1/2) = .8.
// The tolerance is three standard deviations of 4000 draws, 3 √(.8 · .2/4000) = .019.
TEST(GradedAreas, PlacesAreDenserWhereCellsAreSmall) {
    RandomNumbers random(1);
    const GradedAreas areas({1}, size_of_graded_areas);
    int n_low = 0;
    for (int i = 0; i < 4000; ++i) {
        n_low += areas.random_place([&] { return Point{0, -2 + 4 * random.uniform()}; }, random).y < 0 ? 1 : 0;
    }
    EXPECT_NEAR(n_low / 4000.0, 0.8, 0.019);
}

}  // namespace
}  // namespace graincrack::mesher
