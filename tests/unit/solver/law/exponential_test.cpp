// e^(−x) against the library's, and what is made of it.
#include "solver/law/exponential.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/law/contact_law.hpp"
#include "tests/support/check.hpp"

namespace graincrack::test {
namespace {

TEST(Exponential, AgreesWithTheLibraryTo3e16AndFallsSteadily) {
    for (int i = 0; i < 200000; ++i) {
        const double x = i < 100000 ? i * 3e-5 : (i - 100000) * 7e-3;
        const double exact = static_cast<double>(std::exp(-static_cast<long double>(x)));
        ASSERT_LE(std::abs(exp_of_minus(x) - exact), 3e-16 * exact) << x;
        ASSERT_TRUE(x > 20 || exp_of_minus(x + 1e-3) < exp_of_minus(x)) << x;
    }
}

TEST(Exponential, IsZeroFrom700On) {
    EXPECT_EQ(exp_of_minus(0), 1);
    EXPECT_GT(exp_of_minus(699.9), 0);
    EXPECT_EQ(exp_of_minus(700), 0);
    EXPECT_EQ(exp_of_minus(1e300), 0);
}

// [1 − (1 + x) e^(−x)]/x² by its series and its formula, where they meet.
TEST(ExponentialEnergy, IsThatOfASpringAtSmallDisplacements) {
    using contact_law::exponential_energy;
    for (const double x : {0.01999, 0.02001}) {
        const double series = 0.5 - x / 3 + x * x / 8 - x * x * x / 30 + x * x * x * x / 144;
        expect_close(exponential_energy(x, std::exp(-x)), series, 5e-9, 0.5);
    }
    EXPECT_EQ(exponential_energy(0, 1), 0.5);
}

}  // namespace
}  // namespace graincrack::test
