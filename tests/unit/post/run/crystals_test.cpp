#include "post/run/crystals.hpp"

#include <gtest/gtest.h>

#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

TEST(Crystals, AGrainIsOneWhereThereAreNone) {
    Specimen s = test::grid_specimen(2, 1, 0.02, 0.01);
    EXPECT_EQ(number_of_crystals(s), 4U);
    EXPECT_EQ(crystal_of(s, 3), 3U);
    EXPECT_EQ(grains_label(s), "4 grains");
    s.grain_crystal = {0, 0, 1, 1};
    EXPECT_EQ(number_of_crystals(s), 2U);
    EXPECT_EQ(crystal_of(s, 3), 1U);
    EXPECT_EQ(grains_label(s), "2 crystals of 4 elements");
    EXPECT_FALSE(is_within_crystal(s, 0));
    s.contact_kind[0] = static_cast<std::uint8_t>(ContactKind::within_crystal);
    EXPECT_TRUE(is_within_crystal(s, 0));
}

}  // namespace
}  // namespace graincrack
