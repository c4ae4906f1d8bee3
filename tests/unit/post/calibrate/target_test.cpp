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
    const auto value = [&](const std::string& name) { return target_of(name, "targets").read(measures); };
    EXPECT_EQ(value("crack_initiation"), 55e6);
    EXPECT_EQ(value("crack_damage"), 98e6);
    EXPECT_EQ(value("crack_initiation_count"), 80e6);
    EXPECT_TRUE(std::isnan(target_of("crack_damage", "targets").read({{"crack_damage_2d_MPa", 110}})));
}

TEST(CalibrationTarget, ToughnessIsOfHalfDiscs) {
    calibrate::Target target = target_of("toughness", "targets");
    target.value = 1.5e6;
    EXPECT_EQ(target.test(), "bend");
    EXPECT_DOUBLE_EQ(target.read({{"mode_i_toughness_MPa.m^0.5", 1.2}}), 1.2e6);
    EXPECT_TRUE(std::isnan(target.read({{"strength_MPa", 1.2}})));
    EXPECT_DOUBLE_EQ(target.usual_deviation(), 0.15e6);
    EXPECT_EQ(target.text(target.value), "1.5 MPa√m");
    EXPECT_EQ(target.symbol(), "K_IC");
    EXPECT_EQ(target.fitted_name(), "mode_i_toughness");
}

TEST(CalibrationTarget, SurfacesOfAFallAreOfWhatIsLeft) {
    calibrate::Target fall = target_of("drop_50MPa", "targets");
    fall.value = 0.42;
    fall.deviation = 0.1;
    EXPECT_DOUBLE_EQ(fall.logarithm(-0.1), std::log(1.1));
    EXPECT_NEAR(fall.of_logarithm(std::log(1.1)), -0.1, 1e-12);
    EXPECT_DOUBLE_EQ(fall.log_deviation(), 0.1 / 0.58);
    const calibrate::Target strength = target_of("uniaxial", "targets");
    EXPECT_NEAR(strength.of_logarithm(strength.logarithm(122e6)), 122e6, 1);
    EXPECT_TRUE(std::isnan(strength.logarithm(-1)));
}

TEST(CalibrationTarget, ANameThatBeginsWithAnotherIsNotTakenForIt) {
    EXPECT_EQ(target_of("crack_initiation_8MPa", "targets").property.name, "crack_initiation");
    EXPECT_EQ(target_of("crack_initiation_count", "targets").property.name, "crack_initiation_count");
    const calibrate::Target confined = target_of("crack_initiation_count_8MPa", "targets");
    EXPECT_EQ(confined.property.name, "crack_initiation_count");
    EXPECT_EQ(confined.confining_pressure, 8e6);
    EXPECT_EQ(confined.name(), "crack_initiation_count_8MPa");
    EXPECT_EQ(confined.symbol(), "crack initiation by count of cracks at 8 MPa");
}

}  // namespace
}  // namespace graincrack
