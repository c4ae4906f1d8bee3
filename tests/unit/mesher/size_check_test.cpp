#include "mesher/mesh_report.hpp"

#include <gtest/gtest.h>

namespace graincrack::mesher {
namespace {

Material augig_granite() {
    Material material;
    material.name = "Augig granite";
    material.rock = {25.8e9, 0.23, 2650, 1.5e6, 3.0e6, 8.8e6};
    material.contact.tensile_strength = 24.15e6;
    return material;
}

TEST(SizeCheck, LengthsOfAugigGranite) {
    const SizeBounds bounds = size_bounds(augig_granite());
    EXPECT_NEAR(bounds.lower, 0.396e-3, 0.001e-3);
    EXPECT_NEAR(bounds.lower_shear, 1.586e-3, 0.001e-3);
    EXPECT_NEAR(bounds.upper, 8.56e-3, 0.01e-3);
    EXPECT_NEAR(bounds.contact_zone_mixed, 17.0e-3, 0.1e-3);
    EXPECT_NEAR(bounds.contact_zone_mode_i, 3.41e-3, 0.01e-3);
}

TEST(SizeCheck, SaysWhichBoundIsNotKept) {
    const auto lines = describe_size_check(augig_granite(), 1e-3);
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_NE(lines[1].find("kept"), std::string::npos);
    EXPECT_EQ(lines[1].find("not kept"), std::string::npos);
    EXPECT_NE(lines[2].find("not kept: grains are too small"), std::string::npos);
    EXPECT_NE(describe_size_check(augig_granite(), 0.01)[3].find("not kept: grains are too large"), std::string::npos);
}

}  // namespace
}  // namespace graincrack::mesher
