// Sums by lanes: the same bytes on every vector unit, whatever the number of terms.
#include "solver/arithmetic/simd.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

constexpr std::int32_t room = 64;

/// Values of very different sizes, so that another order gives another sum, and rubbish behind them.
std::array<double, room> values_of(std::int32_t count) {
    std::array<double, room> values{};
    for (std::int32_t k = 0; k < room; ++k) values[k] = k < count ? std::sin(7.0 * k) * std::pow(10.0, k % 13) : NAN;
    return values;
}

/// Every eighth value in a lane, then pairs of lanes.
double sum_by_hand(const std::array<double, room>& values, std::int32_t count) {
    std::array<double, 8> lane{};
    for (std::int32_t k = 0; k < count; ++k) lane[k % 8] += values[k];
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

TEST(SumByLanes, IsTheSameOnEveryVectorUnit) {
    for (const std::int32_t count : {0, 1, 7, 8, 9, 50, 63, 64}) {
        const double expected = sum_by_hand(values_of(count), count);
        for (const VectorTarget target : available_vector_targets()) {
            std::array<double, room> values = values_of(count);
            double sum = NAN;
            run_on(target, [&]() GRAINCRACK_KERNEL { sum = sum_values_by_lanes(count, values.data()); });
            EXPECT_EQ(sum, expected) << count << " values on " << name_of(target);
        }
    }
}

}  // namespace
}  // namespace graincrack::test
