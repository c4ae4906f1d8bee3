#include "mesher/plane/random_numbers.hpp"

#include <gtest/gtest.h>

namespace graincrack::mesher {
namespace {

TEST(RandomNumbers, AreTheSameEverywhereAndDifferBetweenSeedsAndStreams) {
    // Computed by another program. They must never change, or the seeds of older specimens would give other specimens.
    RandomNumbers random(1);
    EXPECT_EQ(random.uniform(), 0x1.109f48cd2b630p-1);
    EXPECT_EQ(random.uniform(), 0x1.c90fc93c4f5b7p-1);
    EXPECT_EQ(random.uniform(), 0x1.c7ef13b35fb6cp-1);
    EXPECT_NE(RandomNumbers(1).uniform(), RandomNumbers(2).uniform());
    EXPECT_NE(RandomNumbers(1, 0).uniform(), RandomNumbers(1, 1).uniform());
    EXPECT_NE(RandomNumbers(1, 1).uniform(), RandomNumbers(2, 0).uniform());
}

TEST(RandomNumbers, StayInTheirIntervals) {
    RandomNumbers random(2);
    double mean = 0;
    for (int i = 0; i < 10000; ++i) {
        const double u = random.uniform();
        const double s = random.symmetric();
        ASSERT_TRUE(u >= 0 && u < 1);
        ASSERT_TRUE(s >= -1 && s < 1);
        ASSERT_LT(random.below(7), 7U);
        mean += u / 10000;
    }
    EXPECT_NEAR(mean, 0.5, 0.01);
}

}  // namespace
}  // namespace graincrack::mesher
