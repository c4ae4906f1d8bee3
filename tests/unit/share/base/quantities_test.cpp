#include "share/base/quantities.hpp"

#include <gtest/gtest.h>

namespace graincrack {
namespace {

TEST(Quantities, Bounds) {
    EXPECT_FALSE(quantity::density.admits(0));
    EXPECT_TRUE(quantity::poisson_ratio.admits(0));
    EXPECT_FALSE(quantity::poisson_ratio.admits(0.5));
    EXPECT_FALSE(quantity::damping.admits(1));
    EXPECT_FALSE(quantity::mean_edge.admits(-1));
}

}  // namespace
}  // namespace graincrack
