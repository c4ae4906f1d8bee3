#include "post/measure/toughness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace graincrack {
namespace {

TEST(Bending, NominalStressOfABeam) {
    // M = F S/4 = 1.2 kN, W = H²/6 = 24 mm²: 50 MPa
    EXPECT_NEAR(nominal_bending_stress(100e3, 0.048, 0.012), 50e6, 1);
}

/// Y' = K 2 R t/(F √(π a)).
double half_disc_shape(double notch_share, double span_share) {
    return half_disc_intensity(1, notch_share, 2 * span_share, 1) * 2 / std::sqrt(std::numbers::pi * notch_share);
}

TEST(Bending, IntensityOfAHalfDiscIsThatOfISRM) {
    EXPECT_NEAR(half_disc_shape(0.5, 0.5), 3.680, 5e-4);
    EXPECT_NEAR(half_disc_shape(0.5, 0.6), 4.668, 5e-4);
    EXPECT_NEAR(half_disc_shape(0.5, 0.8), 6.646, 5e-4);
}

/// ASTM E399: K t W^1.5/(F S).
double astm_e399(double x) {
    return 3 * std::sqrt(x) * (1.99 - x * (1 - x) * (2.15 - 3.93 * x + 2.7 * x * x)) / (2 * (1 + 2 * x) * std::pow(1 - x, 1.5));
}

TEST(Bending, IntensityOfANotchedBeamIsThatOfASTMAtFourHeights) {
    EXPECT_NEAR(astm_e399(0.5), 2.66, 5e-3);  // as the standard tabulates it
    for (const double x : {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}) {
        EXPECT_NEAR(notched_beam_intensity(1, x, 4, 1) / 4 / astm_e399(x), 1, 5e-3) << x;
    }
}

// The limits of long spans: a shallow notch in a half-plane has 1.122 σ √(π a), a deep one 3.975 M/b^1.5 (Tada, Paris & Irwin).
TEST(Bending, IntensityInPureBendingHasItsLimits) {
    constexpr double span = 1e9;
    const double shallow = notched_beam_intensity(1, 1e-9, span, 1) / nominal_bending_stress(1, span, 1);
    EXPECT_NEAR(shallow / std::sqrt(std::numbers::pi * 1e-9), 1.122, 2e-3);
    constexpr double ligament = 1e-4;
    EXPECT_NEAR(notched_beam_intensity(1, 1 - ligament, span, 1) / (span / 4) * std::pow(ligament, 1.5), 3.975, 0.02);
}

// A force in the middle lowers the stress below it by 4.43 % at S = 4 H (Timoshenko & Goodier, §40: 3 P l/(4 c²) − 0.133 P/c).
TEST(Bending, AShallowNotchFeelsTheForceAboveIt) {
    constexpr double a = 1e-9;
    const double ratio = notched_beam_intensity(1, a, 4, 1) / notched_beam_intensity(1, a, 1e9, 1) * 1e9 / 4;
    EXPECT_NEAR(ratio, 1 - 0.1773 / 4, 2e-3);
}

}  // namespace
}  // namespace graincrack
