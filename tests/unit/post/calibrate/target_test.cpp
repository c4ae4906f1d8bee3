// What a target is called, and which columns of the tables it is read from.
#include "post/calibrate/target.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graincrack {
namespace {

using calibrate::Measures;
using calibrate::target_of;

TEST(CalibrationTarget, CrackThresholdsAreThoseOfStrainGaugesUnlessTheCountIsAskedFor) {
    const Measures measures{
        {"crack_initiation_MPa", 55}, {"crack_damage_MPa", 98}, {"crack_damage_2d_MPa", 110}, {"crack_initiation_count_MPa", 80}};
    const auto value = [&](const std::string& name) { return target_of(name, "targets").kind.read(measures); };
    EXPECT_EQ(value("crack_initiation"), 55e6);
    EXPECT_EQ(value("crack_damage"), 98e6);
    EXPECT_EQ(value("crack_initiation_count"), 80e6);
    EXPECT_TRUE(std::isnan(target_of("crack_damage", "targets").kind.read({{"crack_damage_2d_MPa", 110}})));
}

TEST(CalibrationTarget, ANameThatBeginsWithAnotherIsNotTakenForIt) {
    EXPECT_EQ(target_of("crack_initiation_8MPa", "targets").kind.name, "crack_initiation");
    EXPECT_EQ(target_of("crack_initiation_count", "targets").kind.name, "crack_initiation_count");
    const calibrate::Target confined = target_of("crack_initiation_count_8MPa", "targets");
    EXPECT_EQ(confined.kind.name, "crack_initiation_count");
    EXPECT_EQ(confined.confining_pressure, 8e6);
    EXPECT_EQ(confined.name(), "crack_initiation_count_8MPa");
    EXPECT_EQ(confined.symbol(), "crack initiation by count of cracks at 8 MPa");
}

}  // namespace
}  // namespace graincrack
