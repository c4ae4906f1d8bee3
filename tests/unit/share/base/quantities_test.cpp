#include "share/base/quantities.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "share/rock/contact_parameters.hpp"

namespace graincrack {
namespace {

TEST(Quantities, ColumnNamesCarryTheUnit) {
    EXPECT_EQ(column_name(quantity::young_modulus, "GPa"), "young_modulus_GPa");
    EXPECT_EQ(column_name(quantity::internal_friction_angle, "deg"), "friction_angle_deg");
    EXPECT_EQ(column_name(quantity::internal_cohesion, "MPa"), "cohesion_MPa");
    EXPECT_EQ(column_name(quantity::poisson_ratio, "1"), "poisson_ratio");
    EXPECT_EQ(column_name(quantity::poisson_ratio, ""), "poisson_ratio");
    EXPECT_EQ(column_name(quantity::edge_spread, "%"), "spread_percent");
    EXPECT_EQ(column_name(contact_parameter(&ContactParameters::fracture_energy).quantity, "J/m2"), "fracture_energy_J_per_m2");
    EXPECT_EQ(column_name(quantity::mode_i_toughness, "MPa.m^0.5"), "mode_i_toughness_MPa_sqrt_m");
    EXPECT_EQ(column_name(contact_parameter(&ContactParameters::normal_stiffness).quantity, "MPa/mm"),
              "contact_normal_stiffness_MPa_per_mm");
    EXPECT_THROW(column_name(quantity::young_modulus, "mm"), std::invalid_argument);
}

TEST(Quantities, Bounds) {
    EXPECT_FALSE(quantity::density.admits(0));
    EXPECT_TRUE(quantity::poisson_ratio.admits(0));
    EXPECT_FALSE(quantity::poisson_ratio.admits(0.5));
    EXPECT_FALSE(quantity::damping.admits(1));
    EXPECT_FALSE(quantity::mean_edge.admits(-1));
}

}  // namespace
}  // namespace graincrack
