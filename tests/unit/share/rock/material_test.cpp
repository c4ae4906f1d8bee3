#include "share/rock/material.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "share/base/error.hpp"
#include "share/base/toml_file.hpp"
#include "share/rock/material_edit.hpp"
#include "tests/support/rows.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;
constexpr double degree = std::numbers::pi / 180;

class MaterialFile : public testing::Test {
protected:
    void SetUp() override {
        unsetenv("GRAINCRACK_MATERIALS");
        folder = fs::temp_directory_path() / ("graincrack-material-" + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override {
        unsetenv("GRAINCRACK_MATERIALS");
        fs::remove_all(folder);
    }

    fs::path write(const std::string& text, const std::string& name = "stone.toml") {
        std::ofstream(folder / name) << text;
        return folder / name;
    }
    /// The error message for a file with this text, without the file's name.
    std::string complaint(const std::string& text) { return complaint_about(write(text).string()); }
    std::string complaint_about(const std::string& name) {
        try {
            read_material(name);
        } catch (const InputError& error) {
            std::string message = error.what();
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            const std::string lead = name + ": ";
            return message.compare(0, lead.size(), lead) == 0 ? message.substr(lead.size()) : message;
        }
        return "nothing wrong";
    }

    fs::path folder;
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

TEST_F(MaterialFile, TheTemplateHasEveryKeyAndReadsOnceItIsFilled) {
    const std::string as_it_is = complaint(material_of_kind(every_key, "marble"));
    EXPECT_TRUE(as_it_is.starts_with("9 keys are missing: ")) << as_it_is;
    const fs::path file = write(filled_template());
    EXPECT_EQ(read_material(file.string()).name, "marble");
    const TomlFile toml = read_toml(file.string());
    std::vector<std::string> keys;
    for (const TomlEntry& entry : toml.entries) {
        if (!entry.section.empty()) keys.push_back(entry.section.front() + "." + entry.key);
    }
    EXPECT_EQ(keys, material_keys());
    EXPECT_NE(material_of_kind(every_key, "marble").find("Zhang 2002"), std::string::npos);
}

TEST_F(MaterialFile, LaboratoryValuesAreEnoughForTheRockOfAProcessZone) {
    const fs::path file = write(
        "name = 'marble'\n[laboratory]\nyoung_modulus = '49 GPa'\npoisson_ratio = 0.19\n"
        "tensile_strength = '6.88 MPa'\n");
    std::vector<std::string> notes;
    const Rock marble = rock_of_laboratory(read_incomplete_material(file.string()), notes);
    EXPECT_EQ(marble.young_modulus, 49e9);
    EXPECT_DOUBLE_EQ(marble.mode_i_toughness, 1e6);
    EXPECT_DOUBLE_EQ(marble.mode_ii_toughness, 2e6);
    EXPECT_EQ(notes.size(), 5U);
    EXPECT_NE(notes[3].find("Zhang 2002"), std::string::npos) << notes[3];
    notes.clear();
    EXPECT_EQ(rock_of_laboratory(read_incomplete_material("augig-granite"), notes).mode_i_toughness, 1.5e6);
    EXPECT_TRUE(notes.empty());
}

TEST_F(MaterialFile, AugigGraniteHasThePublishedNumbers) {
    const IncompleteMaterial granite = read_incomplete_material("augig-granite");
    EXPECT_EQ(granite.material.name, "Augig granite");
    EXPECT_TRUE(granite.missing.empty());
    std::string values;
    for (const auto& [key, value] : granite.values) values += fmt::format("{} {:.4g}, ", key, value);
    EXPECT_EQ(values,
              "contact.cohesion 7.457e+07, contact.friction_angle 0.851, contact.tensile_strength 2.415e+07, "
              "laboratory.cohesion 2.1e+07, laboratory.compressive_strength 1.22e+08, laboratory.friction_angle 0.925, "
              "laboratory.grain_size 0.004, laboratory.max_grain_size 0.006, laboratory.min_grain_size 0.002, "
              "laboratory.poisson_ratio 0.23, laboratory.tensile_strength 8.8e+06, laboratory.young_modulus 2.58e+10, "
              "platen.friction_angle 0.08727, rock.density 2650, rock.mode_i_toughness 1.5e+06, rock.mode_ii_toughness 3e+06, "
              "rock.poisson_ratio 0.23, rock.tensile_strength 8.8e+06, rock.young_modulus 2.58e+10, ");
}

TEST_F(MaterialFile, EveryNumberOfAugigGraniteHasASource) {
    std::ifstream file(GRAINCRACK_SOURCE "/share/materials/augig-granite.toml");
    int numbers = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#' || line[0] == '[' || line.compare(0, 4, "name") == 0) continue;
        ++numbers;
        EXPECT_TRUE(line.find("# [KZ]") != std::string::npos || line.find("# ASSUMED") != std::string::npos) << line;
    }
    EXPECT_EQ(numbers, 19);
}

TEST_F(MaterialFile, ReadsSiNumbersUnitsAndOptionalKeys) {
    const Material material = read_material(
        write(stone + "normal_stiffness = '6e5MPa/mm'\nshear_stiffness = 6e13\nfracture_energy = '90J/m2'\n").string());
    EXPECT_EQ(material.rock.young_modulus, 25.8e9);
    EXPECT_EQ(material.rock.mode_ii_toughness, 3e6);
    EXPECT_EQ(material.contact.normal_stiffness, 6e14);
    EXPECT_EQ(material.contact.shear_stiffness, 6e13);
    EXPECT_EQ(material.contact.fracture_energy, 90);
    EXPECT_EQ(material.platen_friction_angle, 0);
    EXPECT_TRUE(material.laboratory.empty());
    EXPECT_EQ(material.file.filename(), "stone.toml");
}

TEST_F(MaterialFile, TheFabricSaysWhichGrainsAreMade) {
    const Material plain = read_material(write(stone).string());
    EXPECT_TRUE(plain.grains.tessellation.empty() && !plain.grains.grain_size && !plain.grains.size_variation);
    const std::string text = stone + "[fabric]\ntessellation = 'trigon'\ngrain_size = '4 mm'\nsize_variation = 0.6\n";
    const GrainFabric grains =
        read_material(write(text + "elements_per_crystal = 8\nelongation = 1.5\nelongation_angle = '30 deg'\n").string()).grains;
    EXPECT_EQ(grains.tessellation, "trigon");
    EXPECT_DOUBLE_EQ(*grains.grain_size, 4e-3);
    EXPECT_EQ(grains.size_variation, 0.6);
    EXPECT_EQ(grains.elements_per_crystal, 8);
    EXPECT_EQ(grains.elongation, 1.5);
    EXPECT_DOUBLE_EQ(*grains.elongation_angle, 30 * degree);
}

TEST_F(MaterialFile, ComplaintsNameFileKeyAndRemedy) {
    const auto refuse = [&](const std::string& text) { throw InputError(complaint(text)); };
    EXPECT_EQ(test::expect_refused<InputError>("share/rock/material.toml", refuse), 32U);
    EXPECT_NE(complaint_about((folder / "none.toml").string()).find("cannot be read: No such file"), std::string::npos);
    EXPECT_NE(complaint_about(folder.string()).find("cannot be read"), std::string::npos);
}

TEST_F(MaterialFile, AMeasuredToughnessMayNameItsTest) {
    const auto read = [&](const std::string& table) {
        return read_material(write(stone + "\n[laboratory]\nmode_i_toughness = " + table + "\n").string());
    };
    const Material half_disc = read("{value = '1.5 MPa.m^0.5', method = 'half-disc', diameter = '75 mm'}");
    EXPECT_EQ(half_disc.laboratory_value("mode_i_toughness"), 1.5e6);
    EXPECT_EQ(half_disc.toughness_test.text(), "half-disc, diameter 75 mm, notch 18.75 mm, span 45 mm");
    const Material beam = read("{value = 1e6, method = 'beam', height = '40 mm'}");
    EXPECT_EQ(beam.toughness_test.text(), "beam, height 40 mm, notch 20 mm, span 160 mm");
    EXPECT_EQ(beam.toughness_test.caveat(beam.toughness_test), "");
    EXPECT_EQ(beam.toughness_test.caveat(usual_half_disc(0.075)), "other specimen");
    EXPECT_EQ(half_disc.toughness_test.caveat(usual_half_disc(0.08)), "other specimen");
    const ToughnessTest rod = read("{value = 1e6, method = 'short-rod', diameter = '50 mm'}").toughness_test;
    EXPECT_EQ(rod.text(), "short-rod, of which no specimen is made here");
    EXPECT_EQ(rod.caveat(usual_half_disc(0.05)), "other specimen");
    for (const char* table : {"'1.5 MPa.m^0.5'", "{value = 1e6}", "{value = 1e6, method = 'half-disc'}"}) {
        const ToughnessTest unknown = read(table).toughness_test;
        EXPECT_NE(unknown.text().find("of a size that the material does not name"), std::string::npos) << table;
        EXPECT_EQ(unknown.caveat(usual_half_disc(0.08)), "size not known") << table;
    }
}

TEST_F(MaterialFile, NotesStrengthsAndModuliOutOfOrder) {
    const auto noted = [&](const std::string& laboratory) {
        std::string all;
        const std::string text = "name = 'stone'\n" + rock + contact + "[laboratory]\n" + laboratory;
        for (const Remark& note : read_material(write(text).string()).notes) all += note.code.empty() ? "" : note.text;
        return all;
    };
    EXPECT_EQ(noted("compressive_strength = '122 MPa'\n"), "");
    EXPECT_EQ(noted("compressive_strength = '10 MPa'\ntensile_strength = '122 MPa'\nyoung_modulus = '9.8 GPa'\n"),
              "laboratory: the compressive strength of 10 MPa is below the tensile strength of 122 MPa; are they exchanged?");
    EXPECT_EQ(
        noted("compressive_strength = '270 MPa'\nyoung_modulus = '9.8 GPa'\n"),
        "laboratory: a Young's modulus of 9.8 GPa is 36.3 times the compressive strength of 270 MPa; rocks have 100 to 1000 "
        "times; are their units right?");
}

TEST_F(MaterialFile, NotesWhatIsWithoutUnitOrFarOffAnyRock) {
    const std::string units = "name = 'stone'\n" + rock + contact;
    const Material plain = read_material(write(std::string(units).replace(units.find("25.8e9"), 6, "'25.8 GPa'")).string());
    EXPECT_TRUE(plain.notes.empty()) << plain.notes.front().text;
    const std::string file = write(std::string(units).replace(units.find("'24.15MPa'"), 10, "24.15")).string();
    const std::vector<Remark> notes = read_material(file).notes;
    ASSERT_EQ(notes.size(), 3U);
    EXPECT_EQ(notes[0].text, file + ": line 3: rock.young_modulus: 25800000000 has no unit and was taken for 25800000000 Pa");
    EXPECT_EQ(notes[1].text, file + ": line 10: contact.tensile_strength: 24.15 has no unit and was taken for 24.15 Pa");
    EXPECT_EQ(notes[2].code, "unusual_value");
    EXPECT_EQ(notes[2].text, file +
                                 ": line 10: contact.tensile_strength: 24.15 Pa is more than 1000 times below any "
                                 "rock's; is its unit right?");
    for (const char* name : {"augig-granite", "lac-du-bonnet-granite"}) EXPECT_TRUE(read_material(name).notes.empty()) << name;
}

TEST_F(MaterialFile, LooksNamesUp) {
    write(stone, "own-stone.toml");
    setenv("GRAINCRACK_MATERIALS", folder.c_str(), 1);
    EXPECT_EQ(read_material("own-stone").name, "stone");
    EXPECT_EQ(read_material("augig-granite").name, "Augig granite");
    write("name = 'mine'\n" + rock + contact, "augig-granite.toml");
    EXPECT_EQ(read_material("augig-granite").name, "mine");  // the folder that the environment variable names comes first

    const std::string message = complaint_about("augig-granit");
    EXPECT_NE(message.find("not found (did you mean augig-granite?)"), std::string::npos) << message;
    EXPECT_NE(message.find("known are augig-granite, augig-granite-calibrated, augig-granite-triangles, granite-crystals, "
                           "lac-du-bonnet-granite, lac-du-bonnet-granite-calibrated, own-stone"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("looked in " + folder.string() + ", "), std::string::npos) << message;
    EXPECT_NE(message.find("share/graincrack/materials)"), std::string::npos) << message;
    EXPECT_NE(complaint_about("").find("no material given"), std::string::npos);
}

TEST_F(MaterialFile, ContactParametersOfAugigGranite) {
    const Material granite = read_material("augig-granite");
    const ContactParameters p =
        contact_parameters(granite, PlaneCondition::strain, FractureEnergyChoice{FractureEnergyChoice::Kind::mixed});
    EXPECT_NEAR(p.normal_stiffness / 1e9, 6.87e5, 0.005e5);
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

TEST_F(MaterialFile, OwnValuesWinOverDerivedOnesAndAChoiceOverTheFile) {
    Material granite = read_material("augig-granite");
    granite.contact.normal_stiffness = 5e14;
    granite.contact.shear_stiffness = 4e13;
    granite.contact.fracture_energy = 60;
    const ContactParameters p = contact_parameters(granite, PlaneCondition::strain, std::nullopt);
    EXPECT_EQ(p.normal_stiffness, 5e14);
    EXPECT_EQ(p.shear_stiffness, 4e13);
    EXPECT_EQ(p.fracture_energy, 60);
    EXPECT_EQ(effective_fracture_energy(granite, std::nullopt).kind, FractureEnergyChoice::Kind::value);
    const FractureEnergyChoice mode_i{FractureEnergyChoice::Kind::mode_i, 0};
    EXPECT_NEAR(contact_parameters(granite, PlaneCondition::strain, mode_i).fracture_energy, 82.6, 0.05);
}

TEST_F(MaterialFile, ParametersOfSingleLaws) {
    Material granite = read_material("augig-granite");
    const ContactParameters derived = contact_parameters(granite, PlaneCondition::strain, std::nullopt);
    EXPECT_NEAR(derived.mode_ii_fracture_energy, 330.4, 0.05);  // 9 MPa² m (1 − 0.23²)/25.8 GPa
    EXPECT_NEAR(derived.mode_ii_fracture_energy,
                fpz::mixed_mode_fracture_energy(granite.rock, PlaneCondition::strain) -
                    fpz::mode_i_fracture_energy(granite.rock, PlaneCondition::strain),
                1e-10);
    EXPECT_EQ(derived.residual_tensile_strength, 0);
    EXPECT_EQ(derived.residual_cohesion, 0);
    EXPECT_EQ(derived.residual_friction_angle, derived.friction_angle);
    granite = read_material(write(stone + "mode_ii_fracture_energy = '300J/m2'\nresidual_tensile_strength = '1MPa'\n"
                                          "residual_cohesion = '2MPa'\nresidual_friction_angle = '30deg'\n")
                                .string());
    const ContactParameters given = contact_parameters(granite, PlaneCondition::strain, std::nullopt);
    EXPECT_EQ(given.mode_ii_fracture_energy, 300);
    EXPECT_EQ(given.residual_tensile_strength, 1e6);
    EXPECT_EQ(given.residual_cohesion, 2e6);
    EXPECT_DOUBLE_EQ(given.residual_friction_angle, 30 * degree);
    EXPECT_EQ(derived.bridging_strength, 0);
    EXPECT_EQ(derived.bridging_energy, 0);
}

TEST_F(MaterialFile, BridgesNeedBothValuesAndHoldLessThanTheContact) {
    ContactParameters c = contact_parameters(read_material("augig-granite"), PlaneCondition::strain, std::nullopt);
    require_sound_bridges(c, "x");
    c.bridging_strength = 5e6;
    test::expect_one_line<InputError>([&] { require_sound_bridges(c, "x.toml"); },
                                      {"x.toml: bridging_strength is 5 MPa", "bridging_energy is 0"});
    c.bridging_energy = 80;
    require_sound_bridges(c, "x");
    c.bridging_strength = c.tensile_strength;
    test::expect_one_line<InputError>([&] { require_sound_bridges(c, "x.toml"); },
                                      {"bridging_strength is 24.15 MPa and tensile_strength is 24.15 MPa"});
}

TEST(FractureEnergyOption, WordsAndValues) {
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

TEST(TomlFileText, DeepKeysAreRefusedBeforeTheyAreParsed) {
    const auto chain = [](std::size_t n, const std::string& part) {
        std::string key = part;
        for (std::size_t i = 1; i < n; ++i) key += "." + part;
        return key;
    };
    for (const std::string part : {"a", "'a,='", "\"a\\\"[\""}) {
        test::expect_one_line<InputError>([&] { parse_toml("x = 1\n" + chain(1000000, part) + " = 1\n", "deep.toml"); },
                                          {"deep.toml", "line 2", "dots"});
        test::expect_one_line<InputError>([&] { parse_toml("[" + chain(1000, part) + "]\n", "deep.toml"); }, {"line 1", "dots"});
    }
    std::string tables = "x = ";
    for (int i = 0; i < 150; ++i) tables += "{a.b.c = ";
    test::expect_one_line<InputError>([&] { parse_toml(tables + "1" + std::string(150, '}'), "deep.toml"); }, {"nested deeper"});
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
