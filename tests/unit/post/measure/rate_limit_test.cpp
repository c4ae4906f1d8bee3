// The limit of slow loading: known straight lines, and what is refused.
#include "post/measure/rate_limit.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

using test::expect_close;
using test::field;
using test::Recipe;

TEST(RateLimit, AStraightLineEndsAtItsValueWithoutARate) {
    // Strength 100 (1 + 8 T), 120 (1 + 8 T) at tolerances 0.006 and 0.0015.
    const RateLimit limit = extrapolate_rate(std::vector{104.8, 125.76}, std::vector{101.2, 121.44}, 4);
    expect_close(limit.limit, 110, 1e-12, 110);
    expect_close(limit.change.value, 1.048 / 1.012 - 1, 1e-9, 1);
    expect_close(limit.error, 12.706 * 0.12 / 1, 1e-3, 1);  // excesses 1.2 and 1.44: t of one degree of freedom × deviation/√2
}

TEST(RateLimit, ItsErrorIsTheWholeCorrectionIfThatIsMoreThanTheScatter) {
    const RateLimit alone = extrapolate_rate(std::vector{102.0}, std::vector{101.0}, 2);
    EXPECT_EQ(alone.limit, 100);
    EXPECT_EQ(alone.error, 1);
    EXPECT_FALSE(alone.change.low);
    const RateLimit equal = extrapolate_rate(std::vector{102.0, 102.0, 102.0}, std::vector{101.0, 101.0, 101.0}, 3);
    EXPECT_EQ(equal.limit, 100.5);
    EXPECT_EQ(equal.error, 0.5);
}

class RateLimits : public ::testing::Test {
protected:
    std::string run(const std::string& name, double peak, double speed, int seed = 7, double peak_drop = 0.5) {
        Recipe recipe;
        recipe.peak = peak;
        recipe.platen_speed = speed;
        recipe.specimen.seed = seed;
        recipe.drop = peak_drop;
        test::write_run(folder_.file(name), recipe);
        return folder_.file(name);
    }
    static std::string table(const std::vector<std::string>& runs) {
        std::ostringstream out;
        write_rate_limits(out, runs, TableFormat::tsv);
        return out.str();
    }
    test::TemporaryFolder folder_;
};

TEST_F(RateLimits, PairsAreFoundInAnyOrder) {
    const std::string out =
        table({run("a", 102e6, 0.02, 1), run("b", 110e6, 0.01, 2), run("c", 101e6, 0.01, 1), run("d", 112e6, 0.02, 2)});
    EXPECT_EQ(field(out, "strength"), "largest");
    EXPECT_EQ(field(out, "specimens"), "2");
    EXPECT_EQ(field(out, "rate_ratio"), "2");
    EXPECT_EQ(field(out, "fast_MPa"), "107");
    EXPECT_EQ(field(out, "slow_MPa"), "105.5");
    EXPECT_EQ(field(out, "limit_MPa"), "104");
    EXPECT_NE(out.find("\nuniaxial\t0\tfirst-peak\t2\t"), std::string::npos) << out;
}

TEST_F(RateLimits, WhatHasNoLimitIsRefused) {
    const std::string slow = run("slow", 100e6, 0.01);
    const std::string fast = run("fast", 106e6, 0.02);
    test::expect_one_line<InputError>([&] { table({fast, slow}); }, {fast, "+6.0 %", "5 %", "give slower tests"});
    test::expect_one_line<InputError>([&] { table({slow}); }, {slow, "1 run", "needs two"});
    test::expect_one_line<InputError>([&] { table({slow, run("again", 101e6, 0.011)}); }, {"1.2 times", "--rate-tolerance"});
    const std::string third = run("third", 99e6, 0.005);
    test::expect_one_line<InputError>([&] { table({slow, fast, third}); }, {"3 runs"});
    const std::string other = run("other", 101e6, 0.03, 8);
    test::expect_one_line<InputError>(
        [&] {
            table({slow, run("near", 101e6, 0.02), other, run("other-slow", 100e6, 0.01, 8)});
        },
        {other, "ratio"});
}

}  // namespace
}  // namespace graincrack
