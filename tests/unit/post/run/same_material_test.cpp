#include "post/run/comparable.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

RunData run_of(const std::string& name, const std::string& test = "uniaxial", double confining = 0) {
    test::Recipe recipe;
    recipe.test = test;
    recipe.confining_pressure = confining;
    RunData run;
    run.name = name;
    run.header = test::synthetic_header(recipe);
    run.header.damping = 0.8;
    return run;
}

TEST(SameSettings, RunsOfOneTestDifferInTheirSeedsOnly) {
    const RunData first = run_of("a.h5");
    const auto refuse = [&](auto change, const std::string& words) {
        RunData other = run_of("b.h5");
        change(other.header);
        test::expect_one_line<InputError>(
            [&] {
                require_same_settings({first, other}, "a mean");
            },
            {"b.h5: differs from a.h5 in " + words, "a mean needs tests of one kind"});
    };
    refuse([](RunHeader& h) { h.plane = PlaneCondition::stress; }, "the plane condition");
    refuse([](RunHeader& h) { h.platen_speed *= 2; }, "the rate");
    refuse([](RunHeader& h) { h.rate = "auto"; }, "the rate");
    refuse([](RunHeader& h) { h.damping = 0; }, "the damping");
    refuse([](RunHeader& h) { h.mass_scaling = "selective"; }, "the mass scaling");
    refuse([](RunHeader& h) { h.platen_friction = 0.1; }, "the friction of the platens");
}

TEST(SameSettings, OtherTestsAndWhatAnAutomaticRateGaveMayDiffer) {
    RunData slow = run_of("slow.h5", "triaxial", 4e6);
    slow.header.platen_speed /= 2;
    std::vector<RunData> automatic{run_of("a.h5", "tension"), run_of("b.h5", "tension")};
    for (RunData& run : automatic) run.header.rate = "auto";
    automatic[1].header.platen_speed *= 3;
    automatic[1].header.mass_scaling_factor = 70;  // as much as this specimen needs
    EXPECT_NO_THROW(require_same_settings({run_of("u.h5"), slow, automatic[0], automatic[1]}, "a mean"));
}

TEST(SameMaterial, NamesWhatDiffers) {
    const RunData first = run_of("a.h5");
    const auto difference = [&](auto change) {
        RunHeader other = first.header;
        change(other);
        return material_difference(other, first.header);
    };
    EXPECT_EQ(difference([](RunHeader&) {}), "");
    EXPECT_EQ(difference([](RunHeader& h) { h.contact_law = "combined"; }), "the contact law");
    EXPECT_EQ(difference([](RunHeader& h) { h.rock.density = 1; }), "the rock");
    EXPECT_EQ(difference([](RunHeader& h) { h.contact.cohesion = 1; }), "the contact parameters");
    EXPECT_EQ(difference([](RunHeader& h) { h.contact.fracture_energy = 1; }),
              "the stiffness or fracture energy of the contacts");
    EXPECT_EQ(difference([](RunHeader& h) {
                  h.plane = PlaneCondition::stress;  // stiffness and energy follow it
                  h.contact.fracture_energy = 1;
              }),
              "");
}

TEST(SameMaterial, EveryContactParameterMakesAnotherMaterial) {
    const RunData first = run_of("a.h5");
    for (const ContactParameter& row : all_contact_parameters()) {
        RunHeader other = first.header;
        other.contact.*row.value = 1.01 * other.contact.*row.value + 1;
        EXPECT_NE(material_difference(other, first.header), "") << row.quantity.name;
        other.plane = PlaneCondition::stress;
        EXPECT_EQ(material_difference(other, first.header).empty(), row.follows_plane) << row.quantity.name;
    }
}

// The stiffness within crystals follows from the length of their contacts in a specimen; its cohesion is the material's.
TEST(SameMaterial, StiffnessWithinCrystalsIsOfTheSpecimen) {
    RunData first = run_of("a.h5");
    first.header.fabric = uniform_fabric(first.header.rock, first.header.contact, 1);
    first.header.fabric.contacts.assign(3, first.header.contact);
    first.header.class_names = {"rock-rock", "joint", "within_rock"};
    const auto difference = [&](std::size_t contact_class, double ContactParameters::*value) {
        RunHeader other = first.header;
        other.fabric.contacts[contact_class].*value *= 1.1;
        return material_difference(other, first.header);
    };
    EXPECT_EQ(difference(2, &ContactParameters::normal_stiffness), "");
    EXPECT_EQ(difference(2, &ContactParameters::shear_stiffness), "");
    EXPECT_EQ(difference(2, &ContactParameters::cohesion), "the contacts between phases");
    EXPECT_EQ(difference(1, &ContactParameters::normal_stiffness), "the contacts between phases");
}

// tc √(ks/kt) is derived in each plane condition; a last digit that differs makes no other material.
TEST(SameMaterial, RoundOffOfWhatIsDerivedIsNoDifference) {
    RunData strain = run_of("a.h5");
    strain.header.contact.open_shear_strength = 7.7e6;
    RunData stress = run_of("b.h5", "brazilian");
    stress.header.plane = PlaneCondition::stress;
    stress.header.contact.open_shear_strength = strain.header.contact.open_shear_strength * (1 + 1e-15);
    EXPECT_EQ(material_difference(stress.header, strain.header), "");
    stress.header.contact.open_shear_strength = strain.header.contact.open_shear_strength * (1 + 1e-6);
    EXPECT_EQ(material_difference(stress.header, strain.header), "the contact parameters");
}

}  // namespace
}  // namespace graincrack
