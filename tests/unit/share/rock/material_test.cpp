#include "share/rock/material.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include "share/base/error.hpp"
#include "share/base/toml_file.hpp"
#include "share/rock/material_edit.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/rows.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

using test::expect_golden;
constexpr double degree = std::numbers::pi / 180;

class MaterialFile : public testing::Test {
protected:
    MaterialFile() { unsetenv("GRAINCRACK_MATERIALS"); }
    ~MaterialFile() override { unsetenv("GRAINCRACK_MATERIALS"); }

    std::string write(const std::string& text, const std::string& name = "stone.toml") {
        std::ofstream(folder.file(name)) << text;
        return folder.file(name);
    }
    Material read(const std::string& text) { return read_material(write(text)); }

    test::TemporaryFolder folder;
    test::GoldenRefusals refused;
    const std::string rock =
        "[rock]\nyoung_modulus = 25.8e9\npoisson_ratio = 0.23\ndensity = 2650\nmode_i_toughness = '1.5MPa.m^0.5'\n"
        "mode_ii_toughness = '3 MPa√m'\ntensile_strength = '8.8 MPa'\n";
    const std::string contact = "[contact]\ntensile_strength = '24.15MPa'\ncohesion = '74.57 MPa'\nfriction_angle = '48.76deg'\n";
    const std::string stone = "name = 'stone'\n" + rock + contact;
};

/// The template with all of its keys set.
std::string filled_template() {
    std::istringstream lines(material_of_kind(every_key, "marble"));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        const bool is_key = line.starts_with("# ") && line.find(" = ") != std::string::npos && line[2] >= 'a' && line[2] <= 'z';
        text += (is_key ? line.substr(2) : line) + "\n";
    }
    return text;
}

TEST_F(MaterialFile, HasEveryKeyOfTheTemplateAndReadsOnceItIsFilled) {
    refused.add<InputError>("template", [&] { read(material_of_kind(every_key, "marble")); });
    EXPECT_EQ(read(filled_template()).name, "marble");
    std::vector<std::string> keys;
    for (const TomlEntry& entry : read_toml(folder.file("stone.toml")).entries) {
        if (!entry.section.empty()) keys.push_back(entry.section.front() + "." + entry.key);
    }
    EXPECT_EQ(keys, material_keys());
}

TEST_F(MaterialFile, OfLaboratoryValuesIsEnoughForTheRockOfAProcessZone) {
    const std::string file = write(
        "name = 'marble'\n[laboratory]\nyoung_modulus = '49 GPa'\npoisson_ratio = 0.19\n"
        "tensile_strength = '6.88 MPa'\n");
    std::vector<std::string> notes;
    const Rock marble = rock_of_laboratory(read_incomplete_material(file), notes);
    EXPECT_EQ(marble.young_modulus, 49e9);
    EXPECT_DOUBLE_EQ(marble.mode_i_toughness, 1e6);
    EXPECT_DOUBLE_EQ(marble.mode_ii_toughness, 2e6);
    expect_golden(fmt::format("{}", fmt::join(notes, "\n")));
    notes.clear();
    EXPECT_EQ(rock_of_laboratory(read_incomplete_material("augig-granite"), notes).mode_i_toughness, 1.5e6);
    EXPECT_TRUE(notes.empty());
}

TEST_F(MaterialFile, OfAugigGraniteHasThePublishedNumbers) {
    const IncompleteMaterial granite = read_incomplete_material("augig-granite");
    EXPECT_TRUE(granite.missing.empty());
    std::string values = granite.material.name + "\n";
    for (const auto& [key, value] : granite.values) values += fmt::format("{} {:.4g}\n", key, value);
    expect_golden(values);
}

TEST_F(MaterialFile, OfAugigGraniteHasASourceOfEveryNumber) {
    std::ifstream file(GRAINCRACK_SOURCE "/share/materials/augig-granite.toml");
    int numbers = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#' || line[0] == '[' || line.compare(0, 4, "name") == 0) continue;
        ++numbers;
        EXPECT_TRUE(line.find("# [KZ]") != std::string::npos || line.find("# ASSUMED") != std::string::npos) << line;
    }
    EXPECT_EQ(numbers, 19);
}

TEST_F(MaterialFile, ReadsSiNumbersAndUnits) {
    const Material material = read(stone);
    EXPECT_EQ(material.rock.young_modulus, 25.8e9);
    EXPECT_EQ(material.rock.mode_ii_toughness, 3e6);
    EXPECT_EQ(material.platen_friction_angle, 0);
    EXPECT_TRUE(material.laboratory.empty());
    EXPECT_EQ(material.file.filename(), "stone.toml");
    EXPECT_TRUE(material.grains.tessellation.empty() && !material.grains.grain_size && !material.grains.size_variation);
}

TEST_F(MaterialFile, SaysWhichGrainsAreMade) {
    const GrainFabric grains = read(stone +
                                    "[fabric]\ntessellation = 'trigon'\ngrain_size = '4 mm'\nsize_variation = 0.6\n"
                                    "elements_per_crystal = 8\nelongation = 1.5\nelongation_angle = '30 deg'\n")
                                   .grains;
    EXPECT_EQ(grains.tessellation, "trigon");
    EXPECT_DOUBLE_EQ(*grains.grain_size, 4e-3);
    EXPECT_EQ(grains.size_variation, 0.6);
    EXPECT_EQ(grains.elements_per_crystal, 8);
    EXPECT_EQ(grains.elongation, 1.5);
    EXPECT_DOUBLE_EQ(*grains.elongation_angle, 30 * degree);
}

TEST_F(MaterialFile, IsRefusedWithItsNameKeyAndRemedy) {
    const std::string file = folder.file("stone.toml") + ": ";
    const auto refuse = [&](const std::string& text) {
        try {
            read(text);
        } catch (const InputError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(file)) << error.what();
            throw InputError(std::string(error.what()).substr(file.size()));
        }
    };
    EXPECT_EQ(test::expect_refused<InputError>("share/rock/material.toml", refuse), 32U);
    refused.add<InputError>("none", [&] { read_material(folder.file("none.toml")); });
    refused.add<InputError>("folder", [&] { read_material(folder.file("")); });
    refused.add<InputError>("no name", [] { read_material(""); });
}

TEST_F(MaterialFile, MayNameTheTestOfAMeasuredToughness) {
    const std::vector<ToughnessTest> compared{usual_half_disc(0.075), usual_half_disc(0.08)};
    std::string text;
    for (const char* table : {"{value = 1e6, method = 'half-disc', diameter = '75 mm'}", "{value = 1e6}", "'1 MPa.m^0.5'",
                              "{value = 1e6, method = 'half-disc'}", "{value = 1e6, method = 'beam', height = '40 mm'}",
                              "{value = 1e6, method = 'short-rod', diameter = '50 mm'}"}) {
        const Material material = read(stone + "\n[laboratory]\nmode_i_toughness = " + table + "\n");
        EXPECT_EQ(material.laboratory_value("mode_i_toughness"), 1e6);
        const ToughnessTest& test = material.toughness_test;
        text += fmt::format("{}: {}; itself: {}", table, test.text(), test.caveat(test));
        for (const ToughnessTest& other : compared) text += fmt::format("; {}: {}", other.text(), test.caveat(other));
        text += "\n";
    }
    expect_golden(text);
}

TEST_F(MaterialFile, NotesStrengthsAndModuliOutOfOrder) {
    std::string notes;
    for (const char* laboratory : {"compressive_strength = '122 MPa'\n",
                                   "compressive_strength = '10 MPa'\ntensile_strength = '122 MPa'\nyoung_modulus = '9.8 GPa'\n",
                                   "compressive_strength = '270 MPa'\nyoung_modulus = '9.8 GPa'\n"}) {
        notes += laboratory;
        for (const Remark& note : read(stone + "[laboratory]\n" + laboratory).notes) {
            if (!note.code.empty()) notes += "→ " + note.text + "\n";
        }
    }
    expect_golden(notes);
}

TEST_F(MaterialFile, NotesWhatIsWithoutUnitOrFarOffAnyRock) {
    const Material plain = read(std::string(stone).replace(stone.find("25.8e9"), 6, "'25.8 GPa'"));
    EXPECT_TRUE(plain.notes.empty()) << plain.notes.front().text;
    std::string notes;
    for (const Remark& note : read(std::string(stone).replace(stone.find("'24.15MPa'"), 10, "24.15")).notes) {
        notes += note.code + ": " + note.text + "\n";
    }
    expect_golden(notes);
    for (const char* name : {"augig-granite", "lac-du-bonnet-granite"}) EXPECT_TRUE(read_material(name).notes.empty()) << name;
}

TEST_F(MaterialFile, IsLookedForByName) {
    write(stone, "own-stone.toml");
    setenv("GRAINCRACK_MATERIALS", folder.file("").c_str(), 1);
    EXPECT_EQ(read_material("own-stone").name, "stone");
    EXPECT_EQ(read_material("augig-granite").name, "Augig granite");
    write("name = 'mine'\n" + rock + contact, "augig-granite.toml");
    EXPECT_EQ(read_material("augig-granite").name, "mine");  // the folder that the environment variable names comes first
    test::Refusals unknown;
    unknown.add<InputError>("unknown", [] { read_material("augig-granit"); });
    const std::string& message = unknown.text();
    expect_golden(message.substr(0, message.find(", ", message.find(folder.file("")))));  // other folders are of the build
    EXPECT_NE(message.find("share/graincrack/materials)"), std::string::npos) << message;
}

TEST_F(MaterialFile, OfAugigGraniteGivesThePublishedContact) {
    const Material granite = read_material("augig-granite");
    const ContactParameters p =
        contact_parameters(granite, PlaneCondition::strain, FractureEnergyChoice{FractureEnergyChoice::Kind::mixed});
    EXPECT_NEAR(p.fracture_energy, 412.97965, 5e-6);
    EXPECT_NEAR(p.critical_sliding, 2.9025e-6, 5e-11);
    EXPECT_NEAR(contact_parameters(granite, PlaneCondition::stress, std::nullopt).fracture_energy, 87.2, 0.05);  // of mode I
    const double least = p.tensile_strength * p.critical_opening * (std::numbers::e - 2);  // Eq 14 with δut = δct
    const auto with = [&](double Gf) {
        const FractureEnergyChoice choice{FractureEnergyChoice::Kind::value, Gf};
        return contact_parameters(granite, PlaneCondition::strain, choice).ultimate_opening;
    };
    EXPECT_GE(with(least * 1.000001), p.critical_opening);
    EXPECT_LT(with(least * 0.999999), p.critical_opening);
}

TEST_F(MaterialFile, GivesItsOwnValuesAndDerivesOthers) {
    const auto parameters = [](const Material& material) {
        return contact_parameters(material, PlaneCondition::strain, std::nullopt);
    };
    const ContactParameters derived = parameters(read_material("augig-granite"));
    EXPECT_NEAR(derived.mode_ii_fracture_energy, 330.4, 0.05);  // 9 MPa² m (1 − 0.23²)/25.8 GPa
    EXPECT_EQ(derived.residual_friction_angle, derived.friction_angle);
    for (const auto& value : {&ContactParameters::residual_tensile_strength, &ContactParameters::residual_cohesion,
                              &ContactParameters::bridging_strength, &ContactParameters::bridging_energy}) {
        EXPECT_EQ(derived.*value, 0);
    }
    const Material own = read(stone +
                              "normal_stiffness = '6e5MPa/mm'\nshear_stiffness = 6e13\nfracture_energy = '90J/m2'\n"
                              "residual_cohesion = '2MPa'\nresidual_friction_angle = '30deg'\n");
    EXPECT_EQ(parameters(own).normal_stiffness, 6e14);
    EXPECT_EQ(parameters(own).shear_stiffness, 6e13);
    EXPECT_EQ(parameters(own).fracture_energy, 90);
    EXPECT_EQ(parameters(own).residual_cohesion, 2e6);
    EXPECT_DOUBLE_EQ(parameters(own).residual_friction_angle, 30 * degree);
    EXPECT_EQ(effective_fracture_energy(own, std::nullopt).kind, FractureEnergyChoice::Kind::value);
    const FractureEnergyChoice mode_i{FractureEnergyChoice::Kind::mode_i, 0};  // wins over the file
    EXPECT_NEAR(contact_parameters(own, PlaneCondition::strain, mode_i).fracture_energy, 82.6, 0.05);
}

TEST_F(MaterialFile, NeedsBothValuesOfBridgesAndTheyHoldLessThanTheContact) {
    ContactParameters c = contact_parameters(read_material("augig-granite"), PlaneCondition::strain, std::nullopt);
    require_sound_bridges(c, "x");
    const auto refuse = [&] { refused.add<InputError>("bridges", [&] { require_sound_bridges(c, "x.toml"); }); };
    c.bridging_strength = 5e6;
    refuse();
    c.bridging_energy = 80;
    require_sound_bridges(c, "x");
    c.bridging_strength = c.tensile_strength;
    refuse();
}

TEST(FractureEnergyOption, IsAWordOrAValue) {
    using Kind = FractureEnergyChoice::Kind;
    EXPECT_EQ(parse_fracture_energy("mixed", "--fracture-energy").kind, Kind::mixed);
    EXPECT_EQ(parse_fracture_energy("mode-i", "--fracture-energy").kind, Kind::mode_i);
    const auto given = parse_fracture_energy("90J/m2", "--fracture-energy");
    EXPECT_EQ(given.kind, Kind::value);
    EXPECT_EQ(given.value, 90);
    for (const char* text : {"mode-ii", "", "90MPa", "-3", "0", "nan", "Mixed"}) {
        EXPECT_THROW(parse_fracture_energy(text, "--fracture-energy"), UsageError) << text;
    }
    EXPECT_EQ(name_of(Kind::mode_i), "mode-i");
}

TEST(TomlFileText, IsRefusedForDeepKeysBeforeItIsParsed) {
    const auto chain = [](std::size_t n, const std::string& part) {
        std::string key = part;
        for (std::size_t i = 1; i < n; ++i) key += "." + part;
        return key;
    };
    test::GoldenRefusals refused;
    for (const std::string part : {"a", "'a,='", "\"a\\\"[\""}) {
        refused.add<InputError>(part, [&] { parse_toml("x = 1\n" + chain(1000000, part) + " = 1\n", "deep.toml"); });
        refused.add<InputError>(part, [&] { parse_toml("[" + chain(1000, part) + "]\n", "deep.toml"); });
    }
    std::string tables = "x = ";
    for (int i = 0; i < 150; ++i) tables += "{a.b.c = ";
    refused.add<InputError>("tables", [&] { parse_toml(tables + "1" + std::string(150, '}'), "deep.toml"); });
    std::string numbers = "x = [0.1";
    for (int i = 0; i < 1000; ++i) numbers += ", 0.1";
    EXPECT_EQ(parse_toml(numbers + "]\ntext = '" + std::string(1000, '.') + "'\n", "flat.toml").entries.size(), 2U);
}

TEST(TomlFileText, IsFlattenedInTheOrderOfLines) {
    const TomlFile toml = parse_toml("b = 1\na = [1.5, 'x', true]\n[s.t]\nk = 'v'\n[empty]\n", "f.toml");
    ASSERT_EQ(toml.entries.size(), 3U);
    EXPECT_EQ(toml.entries[0].key, "b");
    EXPECT_EQ(toml.entries[0].values.front().text, "1");
    EXPECT_TRUE(toml.entries[1].is_array);
    EXPECT_EQ(toml.entries[1].values.size(), 3U);
    EXPECT_EQ(toml.entries[1].values[0].text, "1.5");
    EXPECT_EQ(toml.entries[2].section, (std::vector<std::string>{"s", "t"}));
    EXPECT_EQ(toml.entries[2].line, 4);
    ASSERT_EQ(toml.sections.size(), 3U);
    EXPECT_THROW(parse_toml("a = [[1]]\n", "f.toml"), InputError);
    EXPECT_THROW(parse_toml("[[a]]\nb = 1\n", "f.toml"), InputError);
}

}  // namespace
}  // namespace graincrack
