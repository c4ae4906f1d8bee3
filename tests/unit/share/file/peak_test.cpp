#include "share/file/peak.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graincrack {
namespace {

TEST(MeanOverStrain, EachStrainCountsEquallyHoweverDenseTheRows) {
    const std::vector<double> strain{0, 0.25, 0.3125, 0.375, 0.5, 1};
    const std::vector<double> value{2, 2, 2, 2, 2, 6};  // 2, from 0.5 on a rise to 6
    const MeanOverStrain curve(strain, value);
    EXPECT_DOUBLE_EQ(curve.mean(0, 1), 0.5 * 2 + 0.5 * 4);
    EXPECT_DOUBLE_EQ(curve.mean(0.25, 0.75), 0.5 * 2 + 0.5 * 3);
    EXPECT_DOUBLE_EQ(curve.mean(0.75, 0.75), 4);
    EXPECT_DOUBLE_EQ(curve.mean(0.75, 3), 5);  // of the part that the curve has
}

TEST(MeanOverStrain, PlatensThatStopOrRetreatLeaveTheFirstValueAtAStrain) {
    const std::vector<double> strain{0, 0.5, 0.5, 0.25, 0.5, 1};
    const std::vector<double> value{1, 1, 7, 7, 7, 1};
    EXPECT_DOUBLE_EQ(MeanOverStrain(strain, value).mean(0, 1), 1);
    EXPECT_EQ(moving_mean(strain, value, 0.1), std::vector<double>(6, 1.0));
}

TEST(MovingMean, KeepsAStraightCurveUpToItsEnds) {
    const std::vector<double> strain{0, 0.1, 0.15, 0.4, 0.7, 0.75, 1};
    std::vector<double> value;
    for (const double x : strain) value.push_back(3 - 2 * x);
    const std::vector<double> smooth = moving_mean(strain, value, 0.3);
    for (std::size_t i = 0; i < strain.size(); ++i) EXPECT_NEAR(smooth[i], value[i], 1e-12) << i;
}

TEST(MovingMean, SpreadsAStepOverItsWindowAndKeepsTheLastValue) {
    std::vector<double> strain;
    std::vector<double> value;
    for (int i = 0; i <= 1000; ++i) {
        strain.push_back(i / 1000.0);
        value.push_back(i <= 500 ? 0 : 1);
    }
    const std::vector<double> smooth = moving_mean(strain, value, 0.2);
    for (const int i : {399, 450, 500, 550, 601}) {
        EXPECT_NEAR(smooth[static_cast<std::size_t>(i)], std::fmin(1, std::fmax(0, (i - 400) / 200.0)), 0.005) << i;
    }
    value.back() = 0;  // a fall in the last row is seen
    EXPECT_EQ(moving_mean(strain, value, 0.2).back(), 0);
}

TEST(MovingMean, OfOneRowIsItsValue) {
    EXPECT_EQ(moving_mean(std::vector<double>{0.5}, std::vector<double>{7}, 1), std::vector<double>{7});
}

}  // namespace
}  // namespace graincrack
