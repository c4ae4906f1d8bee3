#include "post/run/comparability.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

RunData run_of(const std::string& name, const std::string& kind = "uniaxial", double confining = 0) {
    RunData run;
    run.name = name;
    run.header = test::synthetic_header({.test = kind, .confining_pressure = confining});
    using enum SettingGroup;
    run.header.request = {{"rate", 5e-3, Dimension::speed, rate},
                          {"platen_friction", 0.0, Dimension::angle, loading},
                          {"mass_scaling_factor", {}, Dimension::one, loading},
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
    std::erase_if(settings, [&](const Setting& each) { return each.name == setting.name; });
    settings.push_back(setting);
}

/// The runs of each comparable group.
std::vector<std::vector<std::size_t>> members_of(const std::vector<RunData>& runs) {
    std::vector<std::vector<std::size_t>> members;
    for (const ComparableGroup& group : comparable_groups(list_of(runs))) members.push_back(group.runs);
    return members;
}

TEST(Comparability, NeedsTheSameOfAllButTheSeed) {
    const RunData first = run_of("a.h5");
    test::GoldenRefusals refused;
    const auto refuse = [&](auto change) {
        RunData other = run_of("b.h5");
        change(other);
        refused.add<InputError>(differences(other, first), [&] { require_comparable({first, other}, "a mean"); });
    };
    using enum SettingGroup;
    refuse([](RunData& r) { r.header.plane = PlaneCondition::stress; });
    refuse([](RunData& r) { r.header.material = "Gabbro"; });
    refuse([](RunData& r) { r.header.rock.young_modulus = 92e9; });
    refuse([](RunData& r) { r.specimen.width = 0.06; });
    refuse([](RunData& r) { r.specimen.grain_diameter = 5e-3; });
    refuse([](RunData& r) { r.specimen.is_cracked = true; });
    refuse([](RunData& r) { r.specimen.phases["mica"] = 0.5; });
    for (const Setting& setting : Settings{{"rate", 10e-3, Dimension::speed, rate},
                                           {"mass_scaling_factor", 30.0, Dimension::one, loading},
                                           {"peak_drop", 0.0, Dimension::one, end},
                                           {"platen_friction", 0.1, Dimension::angle, loading}}) {
        refuse([&](RunData& r) { set(r.header.request, setting); });
    }
    for (const Setting& setting : Settings{{"holes", std::vector{0.0, 0.0, 5e-3}, Dimension::length, cuts},
                                           {"elongation", 2.0, Dimension::one, fabric},
                                           {"phase_fractions", std::vector{0.3, 0.7}, Dimension::one, material}}) {
        refuse([&](RunData& r) { set(r.specimen.settings, setting); });
    }
}

// What decides a heated test: expansions along and across axes, curves over the temperature.
TEST(Comparability, CountsExpansionsAndCurvesToTheMaterial) {
    RunData first = run_of("a.h5");
    first.header.fabric = uniform_fabric(first.header.rock, first.header.contact, 1);
    first.header.class_names = {"rock-rock"};
    Phase& phase = first.header.fabric.phases[0];
    const auto difference = [&](auto change) {
        RunData other = first;
        change(other.header.fabric.phases[0]);
        return differences(other, first) + "\n";
    };
    EXPECT_EQ(difference([](Phase&) {}), "\n");
    std::string told = difference([](Phase& p) { p.thermal_expansion = 8e-6; });
    phase.along = phase.across = {{0, 7e-6}};
    told += difference([](Phase& p) { p.across = {{0, 13e-6}}; });
    phase.softening = {{0, 1}, {300, 0.8}};
    told += difference([](Phase& p) { p.softening[1][1] = 0.7; });
    test::expect_golden(told);
}

TEST(Comparability, LeavesOutSeedsAndWhatTheyDraw) {
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
TEST(Comparability, HoldsOverAWholeGroup) {
    std::vector<RunData> runs;
    for (const double size : {2.39e-3, 2.0e-3, 2.3e-3, 2.09e-3, 2.49e-3, 2.19e-3}) {
        runs.push_back(run_of("r.h5"));
        runs.back().specimen.grain_diameter = size;
    }
    EXPECT_EQ(members_of(runs), (std::vector<std::vector<std::size_t>>{{1, 3}, {2, 5}, {0, 4}}));
    test::GoldenRefusals().add<InputError>("all", [&] { require_comparable(runs, "a mean"); });
}

TEST(Comparability, TellsInWhatGroupsOfATestDiffer) {
    std::vector<RunData> runs{run_of("a.h5"), run_of("b.h5"), run_of("c.h5"), run_of("d.h5"), run_of("e.h5", "triaxial", 4e6)};
    runs[1].header.material = "Gabbro";
    runs[1].header.rock.young_modulus = 92e9;
    runs[3].specimen.width = 0.06;
    EXPECT_EQ(members_of(runs), (std::vector<std::vector<std::size_t>>{{0, 2}, {1}, {3}, {4}}));
    std::string told;
    for (const ComparableGroup& group : comparable_groups(list_of(runs))) told += "group: " + group.distinction + "\n";
    for (const std::string& name : names_apart({runs[0], runs[1]})) told += "apart: " + name + "\n";
    test::expect_golden(told);
}

TEST(Comparability, CountsATestOfASpecimenOnce) {
    std::vector<RunData> runs{run_of("a.h5"), run_of("b.h5"), run_of("c.h5"), run_of("d.h5")};
    for (RunData& run : runs) run.specimen_digest = "d1";
    runs[1].header.steps = 2 * runs[0].header.steps;  // followed further
    runs[2].specimen_digest = "d2";
    set(runs[3].header.request, {"peak_drop", 0.0, Dimension::one, SettingGroup::end});
    std::ostringstream said;
    EXPECT_EQ(once_each(list_of(runs), "strength", said), (std::vector<std::size_t>{1, 2, 3}));
    test::expect_golden(said.str());
}

TEST(Comparability, AllowsOtherTestsAndWhatAnAutomaticRateGave) {
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
    test::GoldenRefusals().add<InputError>("another grain size", [&] { require_comparable(runs, "a mean"); });
}

TEST(Comparability, ReadsProgramsByTheirMeaning) {
    std::vector<RunData> runs{run_of("a.h5", "program"), run_of("b.h5", "program")};
    runs[0].program = "[stage.fail]\nspeed = 0.5  # slowly\n";
    runs[1].program = "# the same\nstage.fail = { speed = 5e-1 }\n";
    EXPECT_NO_THROW(require_comparable(runs, "a mean"));
    runs[1].program = "[stage.fail]\nspeed = 0.6\n";
    test::GoldenRefusals().add<InputError>("another speed", [&] { require_comparable(runs, "a mean"); });
}

/// In what a run is of another material after a change.
template <class Change>
std::string material_difference(const RunData& first, const Change& change) {
    RunHeader other = first.header;
    change(other);
    return differences(compared_material(other), compared_material(first.header), {SettingGroup::plane});
}

TEST(SameMaterial, HasTheSameLawAndContacts) {
    const RunData first = run_of("a.h5");
    EXPECT_EQ(material_difference(first, [](RunHeader&) {}), "");
    const auto in_plane_stress = [](RunHeader& h) {
        h.plane = PlaneCondition::stress;  // stiffness and energy follow it
        h.contact.fracture_energy = 1;
    };
    EXPECT_EQ(material_difference(first, in_plane_stress), "");
    test::expect_golden(material_difference(first, [](RunHeader& h) { h.contact_law = "combined"; }) + "\n" +
                        material_difference(first, [](RunHeader& h) { h.contact.cohesion = 1e6; }));
}

TEST(SameMaterial, HasTheSameOfEveryContactParameter) {
    const RunData first = run_of("a.h5");
    for (const ContactParameter& row : all_contact_parameters()) {
        for (const auto plane : {PlaneCondition::strain, PlaneCondition::stress}) {
            const std::string difference = material_difference(first, [&](RunHeader& h) {
                h.contact.*row.value = 1.01 * h.contact.*row.value + 1;
                h.plane = plane;
            });
            EXPECT_EQ(difference.empty(), plane == PlaneCondition::stress && row.follows_plane) << row.quantity.name;
        }
    }
}

// The stiffness within crystals follows from the length of their contacts in a specimen; its cohesion is the material's.
TEST(SameMaterial, MayHaveAnotherStiffnessWithinCrystals) {
    RunData first = run_of("a.h5");
    first.header.fabric = uniform_fabric(first.header.rock, first.header.contact, 1);
    first.header.fabric.contacts.assign(3, first.header.contact);
    first.header.class_names = {"rock-rock", "joint", "within_rock"};
    const auto difference = [&](std::size_t contact_class, double ContactParameters::*value) {
        return material_difference(first, [&](RunHeader& h) { h.fabric.contacts[contact_class].*value *= 1.1; });
    };
    EXPECT_EQ(difference(2, &ContactParameters::normal_stiffness), "");
    EXPECT_EQ(difference(2, &ContactParameters::shear_stiffness), "");
    test::expect_golden(difference(2, &ContactParameters::cohesion) + "\n" + difference(1, &ContactParameters::normal_stiffness));
}

// tc √(ks/kt) is derived in each plane condition; a last digit that differs makes no other material.
TEST(SameMaterial, MayDifferByRoundOffOfWhatIsDerived) {
    RunData strain = run_of("a.h5");
    strain.header.contact.open_shear_strength = 7.7e6;
    const auto difference = [&](double share) {
        return material_difference(strain, [&](RunHeader& h) {
            h = run_of("b.h5", "brazilian").header;
            h.plane = PlaneCondition::stress;
            h.contact.open_shear_strength = strain.header.contact.open_shear_strength * (1 + share);
        });
    };
    EXPECT_EQ(difference(1e-15), "");
    test::expect_golden(difference(1e-6));
}

}  // namespace
}  // namespace graincrack
