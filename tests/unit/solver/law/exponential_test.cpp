// e^(−x) against the library's.
#include "solver/law/exponential.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"

namespace graincrack {
namespace {

TEST(Exponential, AgreesWithTheLibraryTo3e16) {
    for (int i = 0; i < 200000; ++i) {
        const double x = i < 100000 ? i * 3e-5 : (i - 100000) * 7e-3;
        const double exact = static_cast<double>(std::exp(-static_cast<long double>(x)));
        ASSERT_LE(std::abs(exp_of_minus(x) - exact), 3e-16 * exact) << x;
    }
}

TEST(Exponential, Ends) {
    EXPECT_EQ(exp_of_minus(0), 1);
    EXPECT_GT(exp_of_minus(699.9), 0);
    EXPECT_EQ(exp_of_minus(700), 0);
    EXPECT_EQ(exp_of_minus(1e300), 0);
}

TEST(Exponential, FallsSteadily) {
    for (double x = 0; x < 20; x += 1e-3) ASSERT_LT(exp_of_minus(x + 1e-3), exp_of_minus(x));
}

}  // namespace
}  // namespace graincrack
