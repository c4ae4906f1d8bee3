#include "post/run/likeness.hpp"

#include <gtest/gtest.h>

#include <sstream>

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
    run.specimen.shape = "rectangle";
    run.specimen.width = 0.03;
    run.specimen.grain_diameter = 3e-3;
    run.specimen.crystals = 200;
    run.specimen.phases = {{"quartz", 0.3}, {"mica", 0.05}};
    return run;
}

TEST(Likeness, RunsOfOneTestDifferInTheirSeedsOnly) {
    const RunData first = run_of("a.h5");
    const auto refuse = [&](auto change, const std::string& words) {
        RunData other = run_of("b.h5");
        change(other);
        EXPECT_EQ(differences(other, first), words);
        test::expect_one_line<InputError>(
            [&] {
                require_alike({first, other}, "a mean");
            },
            {"b.h5: differs from a.h5 in " + words, "a mean needs tests of one kind"});
    };
    refuse([](RunData& r) { r.header.plane = PlaneCondition::stress; }, "plane (stress, strain)");
    refuse([](RunData& r) { r.header.platen_speed *= 2; }, "platen speed (10 mm/s, 5 mm/s)");
    refuse([](RunData& r) { r.header.damping = 0; }, "damping (0, 0.8)");
    refuse([](RunData& r) { r.header.mass_scaling = "selective"; }, "mass scaling (selective, none)");
    refuse([](RunData& r) { r.header.platen_friction = 0.1; }, "platen friction (5.73 deg, 0 deg)");
    refuse([](RunData& r) { r.header.material = "Gabbro"; }, "material (Gabbro, Augig granite)");
    refuse([](RunData& r) { r.header.rock.young_modulus = 92e9; }, "E (92 GPa, 25.8 GPa)");
    refuse([](RunData& r) { r.specimen.width = 0.06; }, "width (60 mm, 30 mm)");
    refuse([](RunData& r) { r.specimen.grain_diameter = 5e-3; }, "grain diameter (5 mm, 3 mm)");
    refuse([](RunData& r) { r.specimen.options["hole"] = "0mm,0mm,5mm"; }, "hole (0mm,0mm,5mm, none)");
    refuse([](RunData& r) { r.specimen.is_cracked = true; }, "cut (cracks, none)");
    refuse([](RunData& r) { r.specimen.options["joint-set"] = "spacing=9mm,dip=0deg"; },
           "joint set (spacing=9mm,dip=0deg, none)");
    refuse([](RunData& r) { r.specimen.phases["mica"] = 0.5; }, "mica (0.5, 0.05)");
    refuse([](RunData& r) { r.specimen.options["elongation"] = "2"; }, "elongation (2, none)");
}

TEST(Likeness, SeedsAndWhatTheyDrawMayDiffer) {
    const RunData first = run_of("a.h5");
    RunData other = run_of("b.h5");
    other.specimen.seed = 2;
    other.specimen.grain_diameter *= 1.03;
    other.specimen.phases["quartz"] += 0.03;
    other.specimen.options = {{"seed", "2"}, {"loaded-diameter", "1"}};
    EXPECT_EQ(differences(other, first), "");
    EXPECT_NO_THROW(require_alike({first, other}, "a mean"));
}

TEST(Likeness, GroupsSayInWhatTheyDifferFromOthersOfTheirTest) {
    std::vector<RunData> runs{run_of("a.h5"), run_of("b.h5"), run_of("c.h5"), run_of("d.h5"), run_of("e.h5", "triaxial", 4e6)};
    runs[1].header.material = "Gabbro";
    runs[1].header.rock.young_modulus = 92e9;
    runs[3].specimen.width = 0.06;
    std::vector<std::vector<std::size_t>> members;
    std::vector<std::string> told;
    for (const LikeGroup& group : groups_of_like(list_of(runs))) {
        members.push_back(group.runs);
        told.push_back(group.distinction);
    }
    EXPECT_EQ(members, (std::vector<std::vector<std::size_t>>{{0, 2}, {1}, {3}, {4}}));
    EXPECT_EQ(told,
              (std::vector<std::string>{"Augig granite, width 30 mm", "Gabbro, width 30 mm", "Augig granite, width 60 mm", ""}));
    EXPECT_EQ(names_apart({runs[0], runs[1]}), (std::vector<std::string>{"uniaxial, Augig granite", "uniaxial, Gabbro"}));
}

TEST(Likeness, ATestOfASpecimenCountsOnce) {
    std::vector<RunData> runs{run_of("a.h5"), run_of("b.h5"), run_of("c.h5")};
    for (RunData& run : runs) run.specimen_digest = "d1";
    runs[1].header.steps = 2 * runs[0].header.steps;  // followed further
    runs[1].header.peak_drop = 0.5;
    runs[2].specimen_digest = "d2";
    std::ostringstream said;
    EXPECT_EQ(once_each(list_of(runs), "strength", said), (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(said.str(), "strength: a.h5 is the same test of the same specimen as b.h5, and counts once\n");
}

TEST(Likeness, OtherTestsAndWhatAnAutomaticRateGaveMayDiffer) {
    RunData slow = run_of("slow.h5", "triaxial", 4e6);
    slow.header.platen_speed /= 2;
    slow.specimen.width *= 2;
    std::vector<RunData> automatic{run_of("a.h5", "tension"), run_of("b.h5", "tension")};
    for (RunData& run : automatic) run.header.rate = "auto";
    automatic[1].header.platen_speed *= 3;
    automatic[1].header.mass_scaling_factor = 70;  // as much as this specimen needs
    std::vector<RunData> runs{run_of("u.h5"), slow, automatic[0], automatic[1]};
    EXPECT_NO_THROW(require_alike(runs, "a mean"));
    runs[1].specimen.grain_diameter *= 1.5;
    test::expect_one_line<InputError>([&] { require_alike(runs, "a mean"); },
                                      {"slow.h5: differs from u.h5 in grain diameter (4.5 mm, 3 mm); a mean needs tests of one "
                                       "material and fabric"});
}

/// In what the second is of another material.
std::string material_difference(const RunHeader& a, const RunHeader& b) {
    return differences(material_traits(a), material_traits(b), {Aspect::plane});
}

TEST(SameMaterial, NamesWhatDiffers) {
    const RunData first = run_of("a.h5");
    const auto difference = [&](auto change) {
        RunHeader other = first.header;
        change(other);
        return material_difference(other, first.header);
    };
    EXPECT_EQ(difference([](RunHeader&) {}), "");
    EXPECT_EQ(difference([](RunHeader& h) { h.contact_law = "combined"; }), "contact law (combined, literal)");
    EXPECT_EQ(difference([](RunHeader& h) { h.contact.cohesion = 1e6; }), "contact cohesion (1 MPa, 74.57 MPa)");
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
    EXPECT_EQ(difference(2, &ContactParameters::cohesion), "contact cohesion of within_rock (82.03 MPa, 74.57 MPa)");
    EXPECT_EQ(difference(1, &ContactParameters::normal_stiffness),
              "contact normal stiffness of joint (7.559e+05 MPa/mm, 6.872e+05 MPa/mm)");
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
    EXPECT_EQ(material_difference(stress.header, strain.header), "contact open shear strength (7.7000077 MPa, 7.7 MPa)");
}

}  // namespace
}  // namespace graincrack
