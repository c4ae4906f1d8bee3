#include "share/file/peak.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace graincrack {
namespace {

TEST(MeanOverStrain, CountsEachStrainEquallyHoweverDenseTheRows) {
    const std::vector<double> strain{0, 0.25, 0.3125, 0.375, 0.5, 1};
    const std::vector<double> value{2, 2, 2, 2, 2, 6};  // 2, from 0.5 on a rise to 6
    const MeanOverStrain curve(strain, value);
    EXPECT_DOUBLE_EQ(curve.mean(0, 1), 0.5 * 2 + 0.5 * 4);
    EXPECT_DOUBLE_EQ(curve.mean(0.25, 0.75), 0.5 * 2 + 0.5 * 3);
    EXPECT_DOUBLE_EQ(curve.mean(0.75, 0.75), 4);
    EXPECT_DOUBLE_EQ(curve.mean(0.75, 3), 5);  // of the part that the curve has
}

TEST(MeanOverStrain, KeepsTheFirstValueAtAStrainWherePlatensStopOrRetreat) {
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
    std::vector<double> strain, value;
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

// Loading to 100 MPa at 0.4 % strain, then a fall within half of the window of smoothing, over which it is hidden.
TEST(Strength, IsTheFirstPeakOrTheLargestStressWhoseFallEndedTheTest) {
    const std::vector<double> strain{0, 0.002, 0.004, 0.00401};
    std::vector<double> stress{0, 50e6, 100e6, 97e6};
    std::vector<double> failed{0, 0, 1, 2};
    RunHeader header;
    const auto strength = [&](const std::string& test, const std::string& stop_reason) {
        header.test = test;
        header.stop_reason = stop_reason;
        const std::optional<Peak> peak = find_strength(header, {strain, stress, failed});
        return peak ? peak->stress : 0;
    };
    EXPECT_EQ(strength("uniaxial", "strain limit"), 0);  // a fall of 3 %
    EXPECT_EQ(strength("uniaxial", "peak drop"), 100e6);
    EXPECT_EQ(strength("brazilian", "strain limit"), 0);
    stress.back() = 90e6;
    EXPECT_EQ(strength("brazilian", "strain limit"), 100e6);
    EXPECT_NEAR(strength("uniaxial", "strain limit"), 100e6, 3e6);  // less what smoothing takes
    failed = {0, 0, 0, 0};
    EXPECT_EQ(strength("brazilian", "strain limit"), 0);
    EXPECT_EQ(strength("uniaxial", "strain limit"), 0);
}

/// A curve through points (strain in %, stress in MPa) in steps of 0.001 %, with failures from the second point on.
double strength_of(const std::string& test, double heat, const std::vector<std::pair<double, double>>& points) {
    std::vector<double> strain, stress, failed;
    for (std::size_t piece = 0; piece + 1 < points.size(); ++piece) {
        const auto [from, low] = points[piece];
        const auto [to, high] = points[piece + 1];
        const double rows = std::round(std::abs(to - from) / 0.001);
        for (double i = 0; i < rows; ++i) {
            strain.push_back(1e-2 * (from + (to - from) * i / rows));
            stress.push_back(1e6 * (low + (high - low) * i / rows));
            failed.push_back(piece > 0 ? 1 : 0);
        }
    }
    RunHeader header;
    header.test = test;
    header.heat = heat;
    header.rock.tensile_strength = 10e6;
    header.stop_reason = "strain limit";
    const std::optional<Peak> peak = find_strength(header, {strain, stress, failed});
    return peak ? peak->stress * 1e-6 : 0;
}

TEST(Strength, IsMissingWherePlatensRetreat) {
    for (const char* test : {"uniaxial", "tension"}) {
        EXPECT_EQ(strength_of(test, 0, {{0, 0}, {0.1, 20}, {0.3, 60}, {0.2, 5}}), 0) << test;
        EXPECT_NEAR(strength_of(test, 0, {{0, 0}, {0.1, 20}, {0.3, 60}, {0.2, 5}, {0.3, 60}, {0.5, 110}, {0.6, 70}}), 110, 1)
            << test;
    }
}

// Faces and cracks that settle: falls of 60 % at 2 MPa and of 20 % at 40, beyond which the stress rises to 80.
TEST(Strength, IsNotWhereAHeatedSpecimenSettles) {
    const std::vector<std::pair<double, double>> settling{{0, 0},     {0.05, 2}, {0.06, 0.8}, {0.3, 50},
                                                          {0.35, 40}, {0.6, 80}, {0.7, 30}};
    EXPECT_NEAR(strength_of("uniaxial", 250, settling), 80, 1);
    EXPECT_NEAR(strength_of("uniaxial", 0, settling), 2, 0.2);
    // Without the last rise the fall at 50 MPa is one of 20 %.
    for (const char* test : {"uniaxial", "program"}) {
        EXPECT_EQ(strength_of(test, 250, {settling.begin(), settling.begin() + 5}), 0) << test;
    }
}

}  // namespace
}  // namespace graincrack
