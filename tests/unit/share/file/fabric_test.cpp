// The fabric of a material: its tables, and the phases and classes that follow.
#include "share/file/fabric.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <string>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/rows.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

using test::TemporaryFolder;

const std::string granite_text = R"(name = "granite"
[rock]
young_modulus = "60 GPa"
poisson_ratio = 0.25
density = "2650 kg/m3"
mode_i_toughness = "1.5 MPa.m^0.5"
mode_ii_toughness = "3 MPa.m^0.5"
tensile_strength = "9 MPa"
[contact]
tensile_strength = "20 MPa"
cohesion = "60 MPa"
friction_angle = "40 deg"
)";
const std::string phases = R"(
[phases]
contrast = 0.5
[phases.quartz]
fraction = 0.3
relative_young_modulus = 1.4
[phases.feldspar]
fraction = 0.6
young_modulus = "57 GPa"
poisson_ratio = 0.27
[phases.mica]
fraction = 0.1
relative_young_modulus = 0.4
density = "3000 kg/m3"
)";
const std::vector<std::string> phase_names{"quartz", "mica", "feldspar"};

Material material_of(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("granite.toml")) << text;
    return read_material(folder.file("granite.toml"));
}
Fabric fabric_from(const std::string& text) {
    return fabric_of(material_of(granite_text + text), PlaneCondition::strain, std::nullopt, phase_names);
}
const ContactParameters& between(const Fabric& fabric, std::size_t a, std::size_t b) {
    return fabric.contacts[contact_class(a, b)];
}
/// Of the rock itself, and of the contacts within the crystals of a phase, `length` of them per area (1/m).
ContactParameters of_rock(const std::string& text) {
    return contact_parameters(material_of(granite_text + text), PlaneCondition::strain, std::nullopt);
}
constexpr double length_per_area = 700;
ContactParameters within(const std::string& text, const std::string& phase, double length = length_per_area) {
    return contact_within_crystals(material_of(granite_text + text), PlaneCondition::strain, std::nullopt, within_class(phase),
                                   length);
}
void expect_same(const ContactParameters& contact, const ContactParameters& other) {
    for (const ContactParameter& row : all_contact_parameters()) EXPECT_EQ(contact.*row.value, other.*row.value) << row.key();
}

TEST(Fabric, GivesGrainsTheirShareOfTheContrast) {
    const Fabric fabric = fabric_from(phases);
    ASSERT_EQ(fabric.phases.size(), 3U);
    EXPECT_NEAR(fabric.phases[0].young_modulus, 60e9 * (1 + 0.5 * 0.4), 1);
    EXPECT_NEAR(fabric.phases[1].young_modulus, 60e9 * (1 - 0.5 * 0.6), 1);
    EXPECT_NEAR(fabric.phases[2].young_modulus, 60e9 * (1 + 0.5 * (0.95 - 1)), 1);
    EXPECT_EQ(fabric.phases[0].poisson_ratio, 0.25);
    EXPECT_EQ(fabric.phases[2].poisson_ratio, 0.27);
    EXPECT_EQ(fabric.phases[1].density, 3000);
    EXPECT_EQ(fabric.phases[2].density, 2650);
}

TEST(Fabric, GivesContactsOfTheRockUnlessSaid) {
    for (const ContactParameters& contact : fabric_from(phases).contacts) {
        expect_same(contact, of_rock(phases));
        EXPECT_EQ(contact.ultimate_opening, of_rock(phases).ultimate_opening);
    }
}

TEST(Fabric, TakesSidesThenPairsThenFactors) {
    const std::string own = R"(
[phases.quartz.contact]
tensile_strength = "30 MPa"
[phases.mica.contact]
tensile_strength = "8 MPa"
[pairs."feldspar-mica"]
cohesion = "10 MPa"
[pairs.heterophase]
tensile_strength = 0.5
)";
    const Fabric mean = fabric_from(phases + own);
    EXPECT_NEAR(between(mean, 0, 0).tensile_strength, 30e6, 1);        // quartz-quartz: no factor
    EXPECT_NEAR(between(mean, 0, 1).tensile_strength, 0.5 * 19e6, 1);  // quartz-mica: mean of 30 and 8
    EXPECT_NEAR(between(mean, 0, 2).tensile_strength, 0.5 * 25e6, 1);  // quartz-feldspar: mean of 30 and the rock's 20
    EXPECT_NEAR(between(mean, 2, 2).tensile_strength, 20e6, 1);
    EXPECT_NEAR(between(mean, 1, 2).cohesion, 10e6, 1);
    EXPECT_NEAR(between(mean, 0, 1).cohesion, 60e6, 1);
    // What derives from a strength follows it.
    EXPECT_NEAR(between(mean, 0, 1).critical_opening * between(mean, 0, 1).normal_stiffness,
                2.718281828459045 * between(mean, 0, 1).tensile_strength, 1);
    const Fabric least = fabric_from(phases + own + "[pairs]\nrule = \"minimum\"\n");
    EXPECT_NEAR(between(least, 0, 1).tensile_strength, 0.5 * 8e6, 1);
    EXPECT_NEAR(between(least, 0, 2).tensile_strength, 0.5 * 20e6, 1);
}

TEST(Fabric, TakesTheHarmonicMeanOfTheSidesAsStiffnessAndKeepsEnergies) {
    const Fabric plain = fabric_from(phases);
    const Fabric of_sides = fabric_from(phases + "[pairs]\nstiffness = \"sides\"\n");
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = a; b < 3; ++b) {
            const double first = plain.phases[a].young_modulus;
            const double second = plain.phases[b].young_modulus;
            const double ratio = 2 * first * second / (first + second) / 60e9;
            EXPECT_NEAR(between(of_sides, a, b).normal_stiffness / between(plain, a, b).normal_stiffness, ratio, 1e-12);
            EXPECT_NEAR(between(of_sides, a, b).shear_stiffness / between(plain, a, b).shear_stiffness, ratio, 1e-12);
            EXPECT_EQ(between(of_sides, a, b).fracture_energy, between(plain, a, b).fracture_energy);
        }
    }
}

TEST(Fabric, ListsValuesWithoutTemperature) {
    const std::string own = R"(
[phases.mica.contact]
friction_angle = "20 deg"
[phases.mica.thermal_expansion_axes]
along = "20e-6 1/K"
across = 9e-6
[phases.quartz.thermal_expansion]
temperatures = [0, "300 K"]
values = ["8e-6 1/K", 1e-5]
[temperature]
temperatures = [0, "480 K"]
young_modulus = [1, 0.8]
[pairs]
rule = "minimum"
stiffness = "sides"
[pairs.homophase]
cohesion = 2
[pairs.within]
fracture_energy = 8
[pairs."mica-quartz"]
fracture_energy = "40 J/m2"
[strength]
modulus = 5
correlation = "10 mm"
)";
    const Material granite = material_of(granite_text + phases + own + "[flaws.joint]\ncohesion = \"1 MPa\"\n");
    std::string values;
    for (const FabricValue& value : fabric_values(granite.fabric)) {
        values +=
            fmt::format("{}.{} = {}\n", value.table, value.key, value.number ? fmt::format("{:.6g}", *value.number) : value.word);
    }
    test::expect_golden(values);
    const Fabric a = fabric_of(granite, PlaneCondition::strain, std::nullopt, phase_names);
    EXPECT_EQ(a.phases[0].along, (TemperatureCurve{{0, 8e-6}, {300, 1e-5}}));
    EXPECT_TRUE(a.phases[1].has_axis());
    EXPECT_EQ(a.phases[2].softening, (TemperatureCurve{{0, 1}, {480, 0.8}}));
}

TEST(Fabric, GivesAClassOfFlawsTheContactOfTheRockAndItsOwnValues) {
    const auto flaw = [](const std::string& text, const std::string& name = "joint") {
        return flaw_contact(material_of(granite_text + text), PlaneCondition::strain, std::nullopt, name);
    };
    const std::string table = "[flaws.joint]\nnormal_stiffness = \"50 GPa/m\"\ncohesion = \"1 MPa\"\n";
    const ContactParameters joint = flaw(table);
    const ContactParameters base = of_rock(table);
    EXPECT_NEAR(joint.normal_stiffness, 50e9, 1);
    EXPECT_NEAR(joint.cohesion, 1e6, 1e-3);
    EXPECT_EQ(joint.shear_stiffness, base.shear_stiffness);
    EXPECT_EQ(joint.friction_angle, base.friction_angle);
    EXPECT_NEAR(joint.critical_opening / base.critical_opening, base.normal_stiffness / 50e9, 1e-9) << "derived anew";
    test::GoldenRefusals().add<InputError>("fault", [&] { flaw(table, "fault"); });
    const std::string bridges = "bridging_strength = \"5 MPa\"\nbridging_energy = \"80 J/m2\"\n";
    EXPECT_EQ(flaw(bridges + "[flaws.joint]\ncohesion = \"1 MPa\"\n").bridging_strength, 0);
    EXPECT_EQ(flaw(bridges + "[flaws.joint]\n" + bridges).bridging_strength, 5e6);
    const auto bridging = [&](const std::string& own) { return within(bridges + own, "rock", 0).bridging_strength; };
    EXPECT_EQ(bridging(""), 5e6);
    EXPECT_EQ(bridging("[pairs.within]\nbridging_strength = 0\nbridging_energy = 0\n"), 0);
    EXPECT_EQ(bridging("[pairs.within]\nbridging_strength = 0.5\n"), 2.5e6);
}

TEST(Fabric, GivesContactsWithinCrystalsThoseOfTheirPhaseUnlessTheyHaveATable) {
    const std::string text = phases + "[pairs.homophase]\ncohesion = 2\n[flaws.within_mica]\ncohesion = \"1 MPa\"\n";
    const Fabric fabric = fabric_from(text);
    ContactParameters quartz = within(text, "quartz");
    quartz.normal_stiffness = between(fabric, 0, 0).normal_stiffness;
    quartz.shear_stiffness = between(fabric, 0, 0).shear_stiffness;
    expect_same(quartz, between(fabric, 0, 0));
    EXPECT_NEAR(within(text, "mica").cohesion, 1e6, 1e-3);
    EXPECT_EQ(within("", "rock").cohesion, of_rock("").cohesion);
}

TEST(Fabric, MakesContactsWithinCrystalsAsStiffAsTheMineralUnlessTheyHaveATable) {
    const std::string text = phases + "[flaws.within_mica]\nnormal_stiffness = \"50 GPa/m\"\n";
    const Fabric fabric = fabric_from(text);
    for (const std::size_t phase : {0U, 1U, 2U}) {
        Rock mineral = material_of(granite_text + text).rock;
        mineral.young_modulus = fabric.phases[phase].young_modulus;
        mineral.poisson_ratio = fabric.phases[phase].poisson_ratio;
        const fpz::ContactStiffness stiff =
            fpz::stiffness_of_added_compliance(mineral, PlaneCondition::strain, compliance_within_crystals, length_per_area);
        const ContactParameters contact = within(text, phase_names[phase]);
        EXPECT_EQ(contact.normal_stiffness, phase == 1 ? 50e9 : stiff.normal);
        EXPECT_EQ(contact.shear_stiffness, stiff.shear);
        EXPECT_EQ(contact.critical_opening, fpz::critical_displacement(contact.tensile_strength, contact.normal_stiffness));
    }
    // Crystals without contacts have no stiffness to derive.
    EXPECT_EQ(within(text, "quartz", 0).normal_stiffness, between(fabric, 0, 0).normal_stiffness);
}

TEST(Fabric, AppliesFactorsWithinCrystalsBehindTheirPhaseAndBeforeTheirTable) {
    const std::string own = R"(
[phases.quartz.contact]
tensile_strength = "30 MPa"
[pairs.homophase]
tensile_strength = 2
)";
    const std::string factors = R"(
[pairs.within]
tensile_strength = 1.25
fracture_energy = 8
normal_stiffness = 3
)";
    const ContactParameters before = within(phases + own, "quartz");
    const ContactParameters quartz = within(phases + own + factors, "quartz");
    EXPECT_NEAR(quartz.tensile_strength, 1.25 * 2 * 30e6, 1);
    EXPECT_NEAR(quartz.fracture_energy, 8 * before.fracture_energy, 1e-9);
    EXPECT_EQ(quartz.mode_ii_fracture_energy, before.mode_ii_fracture_energy);
    EXPECT_EQ(quartz.cohesion, before.cohesion);
    EXPECT_NEAR(quartz.normal_stiffness / before.normal_stiffness, 3, 1e-12) << "of the stiffness of the mineral";
    EXPECT_EQ(quartz.shear_stiffness, before.shear_stiffness);
    // What derives from them follows.
    EXPECT_EQ(quartz.critical_opening, fpz::critical_displacement(quartz.tensile_strength, quartz.normal_stiffness));
    EXPECT_EQ(quartz.ultimate_opening,
              fpz::ultimate_displacement(quartz.fracture_energy, quartz.tensile_strength, quartz.critical_opening));
    const ContactParameters stronger = within(phases + own + "[pairs.within]\ntensile_strength = 1.25\n", "quartz");
    EXPECT_NEAR(stronger.open_shear_strength / before.open_shear_strength, 1.25, 1e-12);
    // Contacts between crystals have none of them.
    const Fabric with = fabric_from(phases + own + factors);
    const Fabric without = fabric_from(phases + own);
    for (std::size_t k = 0; k < with.contacts.size(); ++k) expect_same(with.contacts[k], without.contacts[k]);
    // Values of a table of the class replace them; what it lacks is [contact]'s, with the factors.
    const std::string table = "[flaws.within_quartz]\ntensile_strength = \"12 MPa\"\nnormal_stiffness = \"50 GPa/m\"\n";
    const ContactParameters own_table = within(phases + own + factors + table, "quartz");
    EXPECT_NEAR(own_table.tensile_strength, 12e6, 1);
    EXPECT_NEAR(own_table.normal_stiffness, 50e9, 1);
    EXPECT_NEAR(own_table.fracture_energy, 8 * before.fracture_energy, 1e-9);
    // A material without phases.
    const ContactParameters plain = within(factors, "rock");
    EXPECT_NEAR(plain.tensile_strength, 1.25 * 20e6, 1);
    EXPECT_NEAR(plain.normal_stiffness / within("", "rock").normal_stiffness, 3, 1e-12);
}

// Factors act on what [ratios] give, of contacts between phases and within crystals.
TEST(Fabric, AppliesFactorsToRatios) {
    std::string text = granite_text + phases + "[fabric]\ngrain_size = \"3 mm\"\n[ratios]\ncohesion = 6\nprocess_zone = 0.5\n" +
                       "[pairs.homophase]\ncohesion = 2\n[pairs.within]\nfracture_energy = 8\n";
    const Material material = material_of(text.replace(text.find("cohesion = \"60 MPa\"\n"), 20, ""));
    const Fabric fabric = fabric_of(material, PlaneCondition::strain, std::nullopt, phase_names);
    const double energy = 0.5 * 3e-3 * 20e6 * 20e6 / 60e9;
    EXPECT_DOUBLE_EQ(between(fabric, 0, 0).cohesion, 2 * 6 * 20e6);
    EXPECT_DOUBLE_EQ(between(fabric, 0, 1).cohesion, 6 * 20e6);
    EXPECT_DOUBLE_EQ(between(fabric, 0, 1).fracture_energy, energy);
    const ContactParameters in_quartz =
        contact_within_crystals(material, PlaneCondition::strain, std::nullopt, within_class("quartz"), length_per_area);
    EXPECT_DOUBLE_EQ(in_quartz.cohesion, 2 * 6 * 20e6);
    EXPECT_DOUBLE_EQ(in_quartz.fracture_energy, 8 * energy);
}

TEST(Fabric, MeasuresLengthWithinCrystalsByTheAreaOfTheirPhase) {
    Specimen s = test::one_diagonal_grid(2, 1, 0.02, 0.01);  // two squares of two triangles each: crystals of two phases
    s.phase_names = {"quartz", "mica"};
    s.flaw_names = {"within_quartz", "within_mica"};
    s.contact_flaw.assign(s.n_contacts(), 0);
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = static_cast<std::uint8_t>(g / 2);
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const std::size_t a = s.grain_phase[static_cast<std::size_t>(grain[static_cast<std::size_t>(s.contact_nodes[c][0])])];
        const std::size_t b = s.grain_phase[static_cast<std::size_t>(grain[static_cast<std::size_t>(s.contact_nodes[c][2])])];
        if (a == b) s.contact_flaw[c] = static_cast<std::uint8_t>(1 + a);
    }
    // One diagonal of a square of 1 cm each.
    EXPECT_NEAR(length_within_crystals(s, "within_quartz"), std::sqrt(2.0) / 0.01, 1e-9);
    EXPECT_NEAR(length_within_crystals(s, "within_mica"), std::sqrt(2.0) / 0.01, 1e-9);
    s.contact_flaw.assign(s.n_contacts(), 0);
    EXPECT_EQ(length_within_crystals(s, "within_mica"), 0);
}

TEST(Fabric, TakesThePhasesOfGraniteFromTheirFile) {
    const Material granite = material_of(granite_text + "[phases]\nfrom = \"granite\"\n");
    ASSERT_EQ(granite.fabric.phases.size(), 4U);
    double mean = 0, square = 0;
    for (const auto& [name, phase] : granite.fabric.phases) {
        const double r = relative_young_modulus(phase, granite.rock);
        mean += phase.fraction * r;
        square += phase.fraction * r * r;
    }
    EXPECT_NEAR(mean, 1, 1e-3);
    EXPECT_NEAR(std::sqrt(square - mean * mean), 0.21, 0.01);  // the coefficient of variation that the file names
}

TEST(Fabric, IsRefusedIfItDoesNotFitTogether) {
    EXPECT_EQ(test::expect_refused<InputError>("share/file/fabric.toml",
                                               [](const std::string& text) { material_of(granite_text + text); }),
              22U);
    std::string many = "0";
    for (int i = 1; i <= 1000; ++i) many += fmt::format(",{}", 0.1 * i);
    test::Refusals refused;
    const auto refuse = [&](const std::string& what, const auto& act) { refused.add<InputError>(what, act); };
    refuse("temperatures", [&] { material_of(granite_text + fmt::format("[temperature]\ntemperatures = [{}]\n", many)); });
    refuse("long name", [&] { material_of(granite_text + "[phases." + std::string(257, 'q') + "]\nfraction = 1\n"); });
    const Material granite = material_of(granite_text + phases);
    refuse("other phases", [&] { fabric_of(granite, PlaneCondition::strain, std::nullopt, {"rock"}); });
    refuse("no phases", [&] { require_same_phases(material_of(granite_text), phase_names); });
    test::expect_golden(std::regex_replace(refused.text(), std::regex("qqq+"), "qqq"));
    EXPECT_NO_THROW(require_same_phases(material_of(granite_text), {"rock"}));
}

TEST(Fabric, IsOfAMaterialThatNamesItsLaw) {
    EXPECT_EQ(material_of(granite_text + "law = \"cohesive-frictional\"\n").law, "cohesive-frictional");
    EXPECT_EQ(material_of(granite_text).law, "");
}

}  // namespace
}  // namespace graincrack
