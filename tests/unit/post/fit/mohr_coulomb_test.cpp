// A line through strengths over confining pressures; Table 7 of Kazerani & Zhao (2014) is in tests/unit/post/ccd.
#include "post/fit/mohr_coulomb.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

constexpr double MPa = 1e6;
constexpr double degree = std::numbers::pi / 180;

TEST(MohrCoulomb, GivesCohesionAndFrictionOfALine) {
    const double C = 21 * MPa;
    const double phi = 53 * degree;
    const double b = (1 + std::sin(phi)) / (1 - std::sin(phi));
    const double a = 2 * C * std::sqrt(b);
    EXPECT_NEAR(a / MPa, 125.5, 0.05);  // not the 122 MPa of the laboratory: the three do not agree exactly
    const std::array<double, 4> confining{0, 2 * MPa, 2 * MPa, 9 * MPa};
    const std::array<double, 4> strength{a, a + b * 2 * MPa, a + b * 2 * MPa, a + b * 9 * MPa};
    const MohrCoulomb envelope = fit_mohr_coulomb(confining, strength);
    EXPECT_NEAR(envelope.cohesion / C, 1, 1e-12);
    EXPECT_NEAR(envelope.friction_angle / phi, 1, 1e-12);
    EXPECT_NEAR(envelope.r_squared, 1, 1e-12);
}

TEST(MohrCoulomb, RefusesStrengthsWithoutALine) {
    const std::array<double, 2> same{4 * MPa, 4 * MPa};
    const std::array<double, 2> strength{100 * MPa, 110 * MPa};
    EXPECT_NEAR(mohr_coulomb_slope(std::asin(4.0 / 6)), 5, 1e-12);  // the line of tests/unit/post/summary/summarize_test.cpp
    EXPECT_EQ(mohr_coulomb_slope(0), 1);
    EXPECT_THROW(fit_mohr_coulomb(same, strength), InputError);
    EXPECT_THROW(fit_mohr_coulomb({}, {}), InputError);
    const std::array<double, 2> confining{0, 4 * MPa};
    EXPECT_THROW(fit_mohr_coulomb(confining, std::array<double, 2>{100 * MPa, std::nan("")}), InputError);
    EXPECT_THROW(fit_mohr_coulomb(confining, std::array<double, 1>{1}), std::invalid_argument);
    const MohrCoulomb falling = fit_mohr_coulomb(confining, std::array<double, 2>{100 * MPa, 90 * MPa});
    EXPECT_LT(falling.slope, 0);
    EXPECT_TRUE(std::isnan(falling.cohesion));
    EXPECT_TRUE(std::isnan(falling.friction_angle));
}

}  // namespace
}  // namespace graincrack
