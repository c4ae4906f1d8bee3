// [ratios] of a material: what follows from them, and what wins over them.
#include "share/rock/material.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <tuple>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/rock/material_edit.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

const std::string stone_rock = R"(name = "stone"
[rock]
young_modulus = "50 GPa"
poisson_ratio = 0.25
density = "2650 kg/m3"
mode_i_toughness = "1.5 MPa.m^0.5"
mode_ii_toughness = "3 MPa.m^0.5"
tensile_strength = "10 MPa"
)";
const std::string stone_contact = R"([contact]
tensile_strength = "8 MPa"
friction_angle = "45 deg"
)";
const std::string stone_ratios = R"([ratios]
tensile_strength = 0.9
cohesion = 6.6
process_zone = 0.7
mode_ii_fracture_energy = 40
open_shear_strength = 4
bridging_strength = 0.5
bridging_energy = 2
)";
const std::string stone_fabric = "[fabric]\ngrain_size = \"4 mm\"\n";
const std::string whole_stone = stone_rock + stone_contact + stone_ratios + stone_fabric;

class Ratios : public testing::Test {
protected:
    [[nodiscard]] Material material(const std::string& text) const {
        std::ofstream(file_) << text;
        return read_material(file_);
    }
    static ContactParameters values(const Material& material, const std::optional<FractureEnergyChoice>& choice = std::nullopt) {
        return contact_parameters(material, PlaneCondition::strain, choice);
    }
    test::TemporaryFolder folder_;
    std::string file_ = folder_.file("stone.toml");
};

TEST_F(Ratios, GiveWhatContactDoesNot) {
    const Material stone = material(whole_stone);
    const ContactParameters p = values(stone);
    EXPECT_EQ(p.tensile_strength, 8e6);
    EXPECT_DOUBLE_EQ(p.cohesion, 6.6 * 8e6);
    EXPECT_DOUBLE_EQ(p.open_shear_strength, 4 * 8e6);
    const double energy = 0.7 * 4e-3 * 8e6 * 8e6 / 50e9;  // 3.584 J/m²
    EXPECT_DOUBLE_EQ(p.fracture_energy, energy);
    EXPECT_DOUBLE_EQ(p.mode_ii_fracture_energy, 40 * energy);
    EXPECT_DOUBLE_EQ(p.bridging_strength, 4e6);
    EXPECT_DOUBLE_EQ(p.bridging_energy, 2 * fpz::mode_i_fracture_energy(stone.rock, PlaneCondition::strain));
    EXPECT_DOUBLE_EQ(contact_parameters(stone, PlaneCondition::stress, std::nullopt).fracture_energy, energy);
    EXPECT_EQ(effective_fracture_energy(stone, std::nullopt).kind, FractureEnergyChoice::Kind::value);
    EXPECT_DOUBLE_EQ(effective_fracture_energy(stone, std::nullopt).value, energy);
    // Without a tensile strength of the contact it is by that of the rock.
    const ContactParameters derived =
        values(material(stone_rock + "[contact]\nfriction_angle = 0.7\n" + stone_ratios + stone_fabric));
    EXPECT_DOUBLE_EQ(derived.tensile_strength, 9e6);
    EXPECT_DOUBLE_EQ(derived.cohesion, 6.6 * 9e6);
}

TEST_F(Ratios, FollowATensileStrengthThatIsChanged) {
    Material stone = material(whole_stone);
    stone.contact.tensile_strength = 16e6;  // as an option of the solver does
    EXPECT_DOUBLE_EQ(values(stone).cohesion, 6.6 * 16e6);
    EXPECT_DOUBLE_EQ(values(stone).fracture_energy, 0.7 * 4e-3 * 16e6 * 16e6 / 50e9);
}

TEST_F(Ratios, GiveWayToValuesAndChoices) {
    const Material given = material(stone_rock + stone_contact +
                                    "cohesion = \"30 MPa\"\nfracture_energy = \"20 J/m2\"\nopen_shear_strength = \"5 MPa\"\n" +
                                    stone_ratios + stone_fabric);
    EXPECT_EQ(values(given).cohesion, 30e6);
    EXPECT_EQ(values(given).open_shear_strength, 5e6);
    EXPECT_EQ(values(given).fracture_energy, 20);
    EXPECT_DOUBLE_EQ(values(given).mode_ii_fracture_energy, 40 * 20.0);
    const Material stone = material(whole_stone);
    const double of_toughness = fpz::mode_i_fracture_energy(stone.rock, PlaneCondition::strain);
    EXPECT_EQ(values(stone, FractureEnergyChoice{FractureEnergyChoice::Kind::mode_i}).fracture_energy, of_toughness);
    EXPECT_EQ(values(stone, FractureEnergyChoice{FractureEnergyChoice::Kind::value, 90}).fracture_energy, 90);
    // Over a fracture energy that is derived from the rock.
    const Material only = material(stone_rock + stone_contact + "[ratios]\ncohesion = 5\nmode_ii_fracture_energy = 4\n");
    EXPECT_DOUBLE_EQ(values(only).mode_ii_fracture_energy, 4 * of_toughness);
    EXPECT_EQ(values(only).fracture_energy, of_toughness);
}

TEST_F(Ratios, AreKeysOfAMaterialFile) {
    test::GoldenRefusals refused;
    for (const std::string& text :
         {stone_ratios, std::string("[ratios]\ncohesoin = 3\n"), std::string("[ratios]\ncohesion = 0\n"),
          std::string("[ratios]\ncohesion = \"3 MPa\"\n"), std::string()}) {
        refused.add<InputError>(printable(text), [&] { std::ignore = material(stone_rock + stone_contact + text); });
    }
    std::ofstream(file_) << whole_stone;
    const std::string changed = material_with(file_, {{"ratios.process_zone", "0.5"}, {"contact.tensile_strength", "4 MPa"}});
    EXPECT_DOUBLE_EQ(values(material(changed)).fracture_energy, 0.5 * 4e-3 * 16e12 / 50e9);
}

TEST_F(Ratios, CompleteAMaterialOfLaboratoryValues) {
    const std::string laboratory =
        "name = \"stone\"\n[laboratory]\nyoung_modulus = \"50 GPa\"\npoisson_ratio = 0.25\ndensity = \"2700 kg/m3\"\n"
        "tensile_strength = \"6.88 MPa\"\ngrain_size = \"2 mm\"\n";
    const std::string rest = "[contact]\nfriction_angle = 0.7\n" + stone_ratios + "[fabric]\ntessellation = \"trigon\"\n";
    const Material stone = material(laboratory + rest);
    EXPECT_EQ(stone.rock.young_modulus, 50e9);
    EXPECT_EQ(stone.rock.density, 2700);
    EXPECT_DOUBLE_EQ(stone.rock.mode_i_toughness, 1e6);
    EXPECT_EQ(stone.grains.grain_size, 2e-3);
    EXPECT_DOUBLE_EQ(values(stone).tensile_strength, 0.9 * 6.88e6);
    EXPECT_TRUE(stone.notes.empty());  // `material init` says once what K_IC is unless it was measured
    EXPECT_EQ(material(laboratory + "mode_i_toughness = \"1.2 MPa.m^0.5\"\n" + rest).rock.mode_i_toughness, 1.2e6);
    // A [rock] that says its tensile strength needs its toughness, and triangles by default are of no size.
    test::GoldenRefusals().add<InputError>(
        "rock", [&] { std::ignore = material(laboratory + rest + "[rock]\ntensile_strength = \"7 MPa\"\n"); });
    EXPECT_EQ(material(laboratory + rest + "[rock]\nyoung_modulus = \"60 GPa\"\n").rock.young_modulus, 60e9);
    EXPECT_FALSE(
        material(stone_rock + stone_contact + "cohesion = 1e7\n[laboratory]\ngrain_size = \"2 mm\"\n").grains.grain_size);
}

}  // namespace
}  // namespace graincrack
