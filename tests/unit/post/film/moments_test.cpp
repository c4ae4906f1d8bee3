// Which moments a film shows, and where they lie between rows and frames.
#include "post/film/moments.hpp"

#include <gtest/gtest.h>

namespace graincrack {
namespace {

TEST(PlaceIn, IsBetweenRowsAndAtTheEndsOutside) {
    const std::vector<double> rows{0, 1, 1, 3};
    const auto expect = [&](double value, std::size_t row, double share) {
        const CurvePoint place = place_in(rows, value);
        EXPECT_EQ(place.row, row) << value;
        EXPECT_DOUBLE_EQ(place.share, share) << value;
    };
    expect(-1, 0, 0);
    expect(0.25, 0, 0.25);
    expect(1, 2, 0);  // the last of equal rows
    expect(2.5, 2, 0.75);
    expect(3, 3, 0);
    expect(9, 3, 0);
}

TEST(FilmMoments, AreEvenStepsOfTheStrain) {
    // Twice as fast in the second half.
    const Passage passage({0, 1, 2}, {0, -0.001, -0.003});
    const std::vector<double> moments = film_moments(passage, 0, 2, 7);
    const std::vector<double> expected{0, 0.5, 1, 1.25, 1.5, 1.75, 2};
    ASSERT_EQ(moments.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(moments[i], expected[i], 1e-12) << i;
}

TEST(FilmMoments, CountUnloadingAsLoading) {
    const Passage passage({0, 1, 2, 3}, {0, 0.002, 0.001, 0.002});
    EXPECT_DOUBLE_EQ(passage.at(3), 0.004);
    const std::vector<double> moments = film_moments(passage, 0, 3, 5);
    EXPECT_NEAR(moments[1], 0.5, 1e-12);
    EXPECT_NEAR(moments[3], 2, 1e-12);
}

TEST(FilmMoments, LeaveOutWhereNothingMoves) {
    const Passage passage({0, 1, 5, 6}, {0, 1, 1, 2});
    const std::vector<double> moments = film_moments(passage, 0, 6, 5);
    EXPECT_NEAR(moments[1], 0.5, 1e-12);
    EXPECT_NEAR(moments[2], 5, 1e-12);
    EXPECT_NEAR(moments[3], 5.5, 1e-12);
}

TEST(FilmMoments, BeginAndEndWithTheFrames) {
    const Passage passage({0, 1, 2, 3}, {0, 1, 2, 3});
    const std::vector<double> moments = film_moments(passage, 1, 2, 3);
    EXPECT_EQ(moments.front(), 1);
    EXPECT_NEAR(moments[1], 1.5, 1e-12);
    EXPECT_EQ(moments.back(), 2);
}

TEST(PlaceBetweenFrames, IsTheShareOfTheStrainNotOfTheTime) {
    const Passage passage({0, 1, 2}, {0, 1, 4});
    const CurvePoint place = place_between_frames({0, 2}, passage, 1);
    EXPECT_EQ(place.row, 0U);
    EXPECT_DOUBLE_EQ(place.share, 0.25);
    EXPECT_EQ(place_between_frames({0, 2}, passage, 2).row, 1U);
    EXPECT_EQ(place_between_frames({0, 2}, passage, 2).share, 0);
    // At rest by the time.
    EXPECT_DOUBLE_EQ(place_between_frames({0, 2}, Passage({0, 2}, {1, 1}), 0.5).share, 0.25);
}

}  // namespace
}  // namespace graincrack
