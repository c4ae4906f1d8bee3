// Functions of time.
#include "solver/model/amplitude.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/check.hpp"

namespace graincrack::test {
namespace {

TEST(TimeFunction, HasTheValuesOfItsKind) {
    TimeFunction f{.kind = TimeFunction::Kind::ramp, .value = 3, .from = 1, .duration = 2};
    EXPECT_EQ(f(-1), 1);
    EXPECT_EQ(f(0.5), 1 + 2 * (0.0625 * 2.5));
    EXPECT_EQ(f(1), 2);
    EXPECT_EQ(f(5), 3);
    EXPECT_EQ(f.end(), 2);
    f.kind = TimeFunction::Kind::pulse;
    expect_close(f(1), 4, 1e-15, 1);
    expect_close(f(0.5), 2.5, 1e-15, 1);
    EXPECT_EQ(f(2.1), 1);
    f.kind = TimeFunction::Kind::sine;
    f.frequency = 0.25;
    f.phase = std::numbers::pi / 6;
    expect_close(f(0), 2.5, 1e-15, 1);
    expect_close(f(1), 1 + 3 * std::cos(f.phase), 1e-15, 1);
    EXPECT_EQ(f(2.1), 1);  // half a cycle
    f.duration = 0;
    EXPECT_NE(f(2.1), 1);
    EXPECT_TRUE(std::isinf(f.end()));
    f.kind = TimeFunction::Kind::ricker;
    f.peak_time = 6;
    EXPECT_EQ(f(6), 4);
    // Its zeros are 1/(√2 π f) from the peak, its mean over time is 0.
    expect_close(f(6 + 1 / (std::sqrt(2.0) * std::numbers::pi * f.frequency)), 1, 1e-14, 1);
    double sum = 0;
    for (int i = -3000; i <= 3000; ++i) sum += f(6 + 0.01 * i) - 1;
    expect_close(0.01 * sum, 0, 1e-9, 1);
    EXPECT_LT(std::abs(f(f.end()) - 1), 1e-12);
    const TimeFunction table{.kind = TimeFunction::Kind::table, .times = {1, 2, 4}, .values = {10, 20, 0}};
    for (const auto& [time, value] : {std::pair(0.0, 10), {1.5, 15}, {3.0, 10}, {4.0, 0}, {9.0, 0}}) {
        EXPECT_EQ(table(time), value) << time;
    }
    EXPECT_EQ(table.end(), 4);
}

}  // namespace
}  // namespace graincrack::test
