#include "post/run/comparability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

RunData run_of(const std::string& name, const std::string& kind = "uniaxial", double confining = 0) {
    test::Recipe recipe;
    recipe.test = kind;
    recipe.confining_pressure = confining;
    RunData run;
    run.name = name;
    run.header = test::synthetic_header(recipe);
    using enum SettingGroup;
    run.header.request = {{"rate", 5e-3, Dimension::speed, rate},
                          {"damping", 0.8, Dimension::one, loading},
                          {"platen_friction", 0.0, Dimension::angle, loading},
                          {"mass_scaling_factor", {}, Dimension::one, loading},
                          {"time_step_fraction", 0.7, Dimension::one, loading},
                          {"peak_drop", 0.3, Dimension::one, end}};
    run.specimen.settings = {{"elongation", 1.0, Dimension::one, fabric},
                             {"holes", {}, Dimension::length, cuts},
                             {"phase_fractions", {}, Dimension::one, material}};
    run.specimen.shape = "rectangle";
    run.specimen.width = 0.03;
    run.specimen.grain_diameter = 3e-3;
    run.specimen.crystals = 200;
    run.specimen.phases = {{"quartz", 0.3}, {"mica", 0.05}};
    return run;
}

/// Gives a setting another value, or adds it.
void set(Settings& settings, const Setting& setting) {
    const auto found = std::ranges::find_if(settings, [&](const Setting& each) { return each.name == setting.name; });
    if (found == settings.end()) {
        settings.push_back(setting);
    } else {
        *found = setting;
    }
}

TEST(Comparability, RunsOfOneTestDifferInTheirSeedsOnly) {
    const RunData first = run_of("a.h5");
    const auto refuse = [&](auto change, const std::string& words) {
        RunData other = run_of("b.h5");
        change(other);
        EXPECT_EQ(differences(other, first), words);
        test::expect_one_line<InputError>(
            [&] {
                require_comparable({first, other}, "a mean");
            },
            {"b.h5: differs from a.h5 in " + words, "a mean needs tests of one kind"});
    };
    const auto refuse_setting = [&](const Setting& setting, const std::string& words) {
        refuse([&](RunData& r) { set(r.header.request, setting); }, words);
    };
    const auto refuse_made = [&](const Setting& setting, const std::string& words) {
        refuse([&](RunData& r) { set(r.specimen.settings, setting); }, words);
    };
    using enum SettingGroup;
    refuse([](RunData& r) { r.header.plane = PlaneCondition::stress; }, "plane (stress, strain)");
    refuse([](RunData& r) { r.header.material = "Gabbro"; }, "material (Gabbro, Augig granite)");
    refuse([](RunData& r) { r.header.rock.young_modulus = 92e9; }, "young modulus (92 GPa, 25.8 GPa)");
    refuse([](RunData& r) { r.specimen.width = 0.06; }, "width (60 mm, 30 mm)");
    refuse([](RunData& r) { r.specimen.grain_diameter = 5e-3; }, "grain diameter (5 mm, 3 mm)");
    refuse([](RunData& r) { r.specimen.is_cracked = true; }, "cut (cracks, none)");
    refuse([](RunData& r) { r.specimen.phases["mica"] = 0.5; }, "mica (0.5, 0.05)");
    refuse_setting({"rate", 10e-3, Dimension::speed, rate}, "rate (10 mm/s, 5 mm/s)");
    refuse_setting({"damping", 0.0, Dimension::one, loading}, "damping (0, 0.8)");
    refuse_setting({"mass_scaling_factor", 30.0, Dimension::one, loading}, "mass scaling factor (30, none)");
    refuse_setting({"time_step_fraction", 0.35, Dimension::one, loading}, "time step fraction (0.35, 0.7)");
    refuse_setting({"peak_drop", 0.0, Dimension::one, end}, "peak drop (0, 0.3)");
    refuse_setting({"platen_friction", 0.1, Dimension::angle, loading}, "platen friction (5.73 deg, 0 deg)");
    refuse_made({"holes", std::vector{0.0, 0.0, 5e-3}, Dimension::length, cuts}, "holes (0 m 0 m 5 mm, none)");
    refuse_made({"elongation", 2.0, Dimension::one, fabric}, "elongation (2, 1)");
    refuse_made({"phase_fractions", std::vector{0.3, 0.7}, Dimension::one, material}, "phase fractions (0.3 0.7, none)");
}

// What decides a heated test: expansions along and across axes, curves over the temperature.
TEST(Comparability, ExpansionsAndCurvesAreOfTheMaterial) {
    RunData first = run_of("a.h5");
    first.header.fabric = uniform_fabric(first.header.rock, first.header.contact, 1);
    first.header.class_names = {"rock-rock"};
    const auto difference = [&](auto change) {
        RunData other = first;
        change(other.header.fabric.phases[0]);
        return differences(other, first);
    };
    EXPECT_EQ(difference([](Phase&) {}), "");
    EXPECT_EQ(difference([](Phase& p) { p.thermal_expansion = 8e-6; }), "thermal expansion of rock (8e-06 1/K, 0 1/K)");
    first.header.fabric.phases[0].along = first.header.fabric.phases[0].across = {{0, 7e-6}};
    EXPECT_EQ(difference([](Phase& p) { p.across = {{0, 13e-6}}; }), "thermal expansion across of rock (0 1.3e-05, 0 7e-06)");
    first.header.fabric.phases[0].softening = {{0, 1}, {300, 0.8}};
    EXPECT_EQ(difference([](Phase& p) { p.softening[1][1] = 0.7; }), "softening of rock (0 1 300 0.7, 0 1 300 0.8)");
}

TEST(Comparability, SeedsAndWhatTheyDrawMayDiffer) {
    const RunData first = run_of("a.h5");
    RunData other = run_of("b.h5");
    other.specimen.seed = 2;
    other.specimen.grain_diameter *= 1.03;
    other.specimen.phases["quartz"] += 0.03;
    other.header.platen_speed *= 1.1;  // of the automatic rate: a result
    set(other.specimen.settings, {"seed", std::uint64_t{2}, Dimension::one, SettingGroup::seed});
    set(other.specimen.settings, {"loaded_diameter", 1.0, Dimension::one, SettingGroup::seed});
    EXPECT_EQ(differences(other, first), "");
    EXPECT_NO_THROW(require_comparable({first, other}, "a mean"));
}

// Six grain sizes of which each agrees with its neighbours, the first and the last not: 2.00 to 2.49 mm.
TEST(Comparability, AgreesOverAWholeGroup) {
    std::vector<RunData> runs;
    for (const double size : {2.39e-3, 2.0e-3, 2.3e-3, 2.09e-3, 2.49e-3, 2.19e-3}) {
        runs.push_back(run_of("r.h5"));
        runs.back().specimen.grain_diameter = size;
    }
    std::vector<std::vector<std::size_t>> members;
    for (const ComparableGroup& group : comparable_groups(list_of(runs))) members.push_back(group.runs);
    EXPECT_EQ(members, (std::vector<std::vector<std::size_t>>{{1, 3}, {2, 5}, {0, 4}}));
    test::expect_one_line<InputError>([&] { require_comparable(runs, "a mean"); }, {"grain diameter (2 mm, 2.4 mm)"});
}

TEST(Comparability, GroupsSayInWhatTheyDifferFromOthersOfTheirTest) {
    std::vector<RunData> runs{run_of("a.h5"), run_of("b.h5"), run_of("c.h5"), run_of("d.h5"), run_of("e.h5", "triaxial", 4e6)};
    runs[1].header.material = "Gabbro";
    runs[1].header.rock.young_modulus = 92e9;
    runs[3].specimen.width = 0.06;
    std::vector<std::vector<std::size_t>> members;
    std::vector<std::string> told;
    for (const ComparableGroup& group : comparable_groups(list_of(runs))) {
        members.push_back(group.runs);
        told.push_back(group.distinction);
    }
    EXPECT_EQ(members, (std::vector<std::vector<std::size_t>>{{0, 2}, {1}, {3}, {4}}));
    EXPECT_EQ(told,
              (std::vector<std::string>{"Augig granite, width 30 mm", "Gabbro, width 30 mm", "Augig granite, width 60 mm", ""}));
    EXPECT_EQ(names_apart({runs[0], runs[1]}), (std::vector<std::string>{"uniaxial, Augig granite", "uniaxial, Gabbro"}));
}

TEST(Comparability, ATestOfASpecimenCountsOnce) {
    std::vector<RunData> runs{run_of("a.h5"), run_of("b.h5"), run_of("c.h5"), run_of("d.h5")};
    for (RunData& run : runs) run.specimen_digest = "d1";
    runs[1].header.steps = 2 * runs[0].header.steps;  // followed further
    runs[2].specimen_digest = "d2";
    set(runs[3].header.request, {"peak_drop", 0.0, Dimension::one, SettingGroup::end});
    std::ostringstream said;
    EXPECT_EQ(once_each(list_of(runs), "strength", said), (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_EQ(said.str(), "strength: a.h5 is the same test of the same specimen as b.h5, and counts once\n");
}

TEST(Comparability, OtherTestsAndWhatAnAutomaticRateGaveMayDiffer) {
    RunData slow = run_of("slow.h5", "triaxial", 4e6);
    set(slow.header.request, {"rate", 2.5e-3, Dimension::speed, SettingGroup::rate});
    slow.specimen.width *= 2;
    std::vector<RunData> automatic{run_of("a.h5", "tension"), run_of("b.h5", "tension")};
    for (RunData& run : automatic) set(run.header.request, {"rate", "auto", Dimension::speed, SettingGroup::rate});
    automatic[1].header.platen_speed *= 3;
    automatic[1].header.mass_scaling_factor = 70;  // as much as this specimen needs
    std::vector<RunData> runs{run_of("u.h5"), slow, automatic[0], automatic[1]};
    EXPECT_NO_THROW(require_comparable(runs, "a mean"));
    runs[1].specimen.grain_diameter *= 1.5;
    test::expect_one_line<InputError>([&] { require_comparable(runs, "a mean"); },
                                      {"slow.h5: differs from u.h5 in grain diameter (4.5 mm, 3 mm); a mean needs tests of one "
                                       "material and fabric"});
}

TEST(Comparability, ProgramsAreComparedByWhatTheySay) {
    std::vector<RunData> runs{run_of("a.h5", "program"), run_of("b.h5", "program")};
    runs[0].program = "[stage.fail]\nspeed = 0.5  # slowly\n";
    runs[1].program = "# the same\nstage.fail = { speed = 5e-1 }\n";
    EXPECT_NO_THROW(require_comparable(runs, "a mean"));
    runs[1].program = "[stage.fail]\nspeed = 0.6\n";
    test::expect_one_line<InputError>([&] { require_comparable(runs, "a mean"); }, {"b.h5: differs from a.h5 in program"});
}

/// In what the second is of another material.
std::string material_difference(const RunHeader& a, const RunHeader& b) {
    return differences(compared_material(a), compared_material(b), {SettingGroup::plane});
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
