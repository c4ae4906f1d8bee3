#include "post/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace graincrack {
namespace {

TEST(Statistics, StudentIsThatOfTables) {
    EXPECT_NEAR(student_t_95(1), 12.706205, 1e-6);  // printed tables of t(0.975)
    EXPECT_NEAR(student_t_95(7), 2.364624, 1e-6);
}

TEST(Statistics, SampleHasMeanDeviationAndInterval) {
    const std::array<double, 4> values{2, 4, 4, 6};
    const Sample s = sample(values);
    EXPECT_DOUBLE_EQ(s.mean.value, 4);
    EXPECT_NEAR(*s.deviation, std::sqrt(8.0 / 3), 1e-12);
    EXPECT_NEAR(*s.mean.low, 4 - 3.182446 * std::sqrt(8.0 / 3) / 2, 1e-6);  // t(0.975, 3) = 3.182446
    const Sample one = sample(std::array<double, 1>{3});
    EXPECT_DOUBLE_EQ(one.mean.value, 3);
    EXPECT_FALSE(one.deviation.has_value());
    EXPECT_FALSE(one.mean.low.has_value());
}

TEST(Statistics, LineWithVariancesByHand) {
    const std::array<double, 4> x{0, 1, 2, 3};
    const std::array<double, 4> y{1, 3, 4, 8};  // by hand: slope 2.2, intercept 0.7, scatter 1.8, Sxx 5
    const auto line = fit_line(x, y);
    ASSERT_TRUE(line.has_value());
    EXPECT_NEAR(line->slope, 2.2, 1e-12);
    EXPECT_NEAR(line->intercept, 0.7, 1e-12);
    EXPECT_NEAR(line->slope_variance, 1.8 / 2 / 5, 1e-12);
    EXPECT_NEAR(line->intercept_variance, 0.9 * (0.25 + 1.5 * 1.5 / 5), 1e-12);
    EXPECT_NEAR(line->covariance, -0.9 * 1.5 / 5, 1e-12);
    EXPECT_NEAR(line->r_squared, 1 - 1.8 / 26, 1e-12);
    EXPECT_EQ(line->freedom, 2);
    EXPECT_FALSE(fit_line(std::array<double, 2>{1, 1}, std::array<double, 2>{1, 2}).has_value());
}

TEST(Statistics, WeightsCountLikeRepetitions) {
    const std::array<double, 3> x{0, 1, 3};
    const std::array<double, 3> y{1, 4, 6};
    const auto weighted = fit_line(x, y, std::array<double, 3>{1, 2, 1});
    const auto repeated = fit_line(std::array<double, 4>{0, 1, 1, 3}, std::array<double, 4>{1, 4, 4, 6});
    EXPECT_NEAR(weighted->slope, repeated->slope, 1e-12);
    EXPECT_NEAR(weighted->intercept, repeated->intercept, 1e-12);
    EXPECT_NEAR(weighted->r_squared, repeated->r_squared, 1e-12);
}

}  // namespace
}  // namespace graincrack
