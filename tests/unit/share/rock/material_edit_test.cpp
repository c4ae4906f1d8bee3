// A material file with other values, its comments kept.
#include "share/rock/material_edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <tuple>

#include "share/base/error.hpp"
#include "share/rock/material.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

class MaterialWith : public ::testing::Test {
protected:
    std::string file(const std::string& text) {
        std::ofstream(path_) << text;
        return path_;
    }
    test::TemporaryFolder folder_;
    std::string path_ = folder_.file("stone.toml");
    test::GoldenRefusals refused;
};

TEST_F(MaterialWith, ChangesItsLinesAndNoOthers) {
    const std::string stone = file(
        "# a stone\nname = \"stone\"\n[rock]\nyoung_modulus = 25.8e9  # bare\n\n[contact]  # grains\ncohesion = \"70 MPa\"\n"
        "friction_angle = 0.5 # rad\n");
    test::expect_golden(material_with(stone, {{"contact.cohesion", "71 MPa"}, {"rock.poisson_ratio", "0.2"}, {"name", "slate"}}));
}

TEST_F(MaterialWith, KeepsCommentsAndSpellings) {
    const std::string stone = file(
        "name = \"stone\"\nrock.young_modulus = \"25 GPa\" # [1] Table 5\n[phases.mica] # black\nfraction = 1\n"
        "[phases.mica.thermal_expansion_axes]\nalong = [1e-5, # cold\n 2e-5] # hot\nacross = [0,\n 0]\n"
        "temperatures = [0, 300]\n\n[fitted]\nyoung_modulus = \"25\"\n# of the user\n[study]\npoints = 9\n");
    test::expect_golden(material_with(stone, {{"rock.young_modulus", "30 GPa"},
                                              {"rock.density", "2700"},
                                              {"contact.law", "a\"b"},
                                              {"phases.mica.thermal_expansion_axes.along", "3e-5"}}));
}

TEST_F(MaterialWith, AddsTables) {
    const std::string stone = file("name = \"stone\"\n");
    const std::string changed = material_with(stone, {{"laboratory.cohesion", "21 MPa"},
                                                      {"contact.cohesion", "7e7"},
                                                      {"contact.tensile_strength", "9 MPa"},
                                                      {"rock.poisson_ratio", ".2"}});
    const auto read = read_incomplete_material(file(changed));
    EXPECT_EQ(read.values, (std::map<std::string, double>{{"contact.cohesion", 70e6},
                                                          {"contact.tensile_strength", 9e6},
                                                          {"laboratory.cohesion", 21e6},
                                                          {"rock.poisson_ratio", 0.2}}));
}

// What a material gives of a phase of a file of phases stands beside what it does not give.
TEST_F(MaterialWith, ChangesPhasesOfAFile) {
    const std::string granite = file("name = \"stone\"\n[phases]\nfrom = \"granite\"\n");
    const auto before = read_incomplete_material(granite).material.fabric.phases;
    const auto after = read_incomplete_material(file(material_with(granite, {{"phases.quartz.thermal_expansion", "9e-6 1/K"},
                                                                             {"phases.mica.density", "3000"},
                                                                             {"phases.mica.contact.cohesion", "9 MPa"}})));
    EXPECT_TRUE(std::none_of(after.missing.begin(), after.missing.end(), [](auto& key) { return key.starts_with("phases"); }));
    const auto& phases = after.material.fabric.phases;
    ASSERT_EQ(phases.size(), before.size());
    EXPECT_TRUE(before.at("quartz").expansion_along && before.at("quartz").expansion_across);
    EXPECT_EQ(phases.at("quartz").thermal_expansion, 9e-6);
    EXPECT_EQ(phases.at("quartz").expansion_along, std::nullopt);
    EXPECT_EQ(phases.at("quartz").fraction, before.at("quartz").fraction);
    EXPECT_EQ(phases.at("mica").density, 3000);
    EXPECT_EQ(phases.at("mica").contact.cohesion, 9e6);
    EXPECT_EQ(phases.at("mica").relative_young_modulus, before.at("mica").relative_young_modulus);
    EXPECT_EQ(phases.at("plagioclase").fraction, before.at("plagioclase").fraction);
}

TEST_F(MaterialWith, EntersValuesIntoATemplate) {
    const std::string text = new_material("every-key", "marble", {{"laboratory.cohesion", "23 MPa"}, {"rock.density", "2700"}});
    const auto read = read_incomplete_material(file(text));
    EXPECT_EQ(read.values, (std::map<std::string, double>{{"laboratory.cohesion", 23e6}, {"rock.density", 2700}}));
    EXPECT_NE(text.find("\ndensity = 2700        "), std::string::npos) << text;
    EXPECT_EQ(text.find("# density = "), text.rfind("# density = "));  // that of the laboratory
    const std::vector<MaterialSetting> colour{{"rock.colour", "white"}};
    refused.add<UsageError>("colour", [&] { std::ignore = new_material("every-key", "marble", colour); });
}

TEST_F(MaterialWith, ChangesTablesOnALine) {
    const auto toughness = [&](const std::string& was, const std::vector<MaterialSetting>& settings) {
        const std::string text =
            material_with(file("name = \"stone\"\n[laboratory]\nmode_i_toughness = " + was + "\n"), settings);
        return text.substr(text.find("mode_i"), text.rfind('}') + 1 - text.find("mode_i"));
    };
    const std::string key = "laboratory.mode_i_toughness";
    EXPECT_EQ(toughness("1.5e6", {{key + ".method", "half-disc"}, {key + ".diameter", "75 mm"}, {key, "1.4 MPa.m^0.5"}}),
              "mode_i_toughness = {value = \"1.4 MPa.m^0.5\", method = \"half-disc\", diameter = \"75 mm\"}");
    EXPECT_EQ(toughness("{value = 1.5e6, method = 'ring'}  # ring", {{"rock.density", "2700"}}),
              "mode_i_toughness = {value = 1.5e6, method = 'ring'}");
    const std::string begun = new_material("granite", "rock", {{key + ".method", "half-disc"}, {key, "1.4e6"}});
    EXPECT_EQ(read_incomplete_material(file(begun)).values.at(key), 1.4e6);
    EXPECT_NE(material_with(file("name = \"stone\"\ncontact = {cohesion = 1e6}\n"), {{"contact.cohesion", "2 MPa"}})
                  .find("contact = {cohesion = \"2 MPa\"}"),
              std::string::npos);
}

TEST_F(MaterialWith, TakesWhatTheCommentsOfATemplateShow) {
    const std::string text = new_material(
        "marble", "stone",
        {{"laboratory.mode_i_toughness", "{value = \"1.4 MPa.m^0.5\", method = \"half-disc\", diameter = \"75 mm\"}"},
         {"laboratory.young_modulus", "\"25.8 GPa\""}});
    const auto read = read_incomplete_material(file(text));
    EXPECT_EQ(read.values.at("laboratory.mode_i_toughness"), 1.4e6);
    EXPECT_EQ(read.material.toughness_test.method, "half-disc");
    EXPECT_EQ(read.material.toughness_test.size, 0.075);
    EXPECT_EQ(read.values.at("laboratory.young_modulus"), 25.8e9);
    EXPECT_EQ(read.material.kind, "marble");
}

TEST_F(MaterialWith, RefusesWhatItCannotSet) {
    const std::string stone =
        file("name = \"stone\"\n[phases.mica]\nfraction = 1\nthermal_expansion = {temperatures = [0], values = [1e-5]}\n");
    for (const auto& [key, value] : std::map<std::string, std::string>{{"contact.cohesoin", "1 MPa"},
                                                                       {"rock.density", "1 MPa"},
                                                                       {"name", "a \"b\""},
                                                                       {"laboratory.mode_i_toughness", "{sise = 1}"}}) {
        const std::vector<MaterialSetting> settings{{key, value}};
        refused.add<UsageError>(key, [&] { std::ignore = material_with(stone, settings); });
    }
    const std::vector<MaterialSetting> table{{"phases.mica.thermal_expansion", "1e-5"}};
    refused.add<InputError>("table", [&] { std::ignore = material_with(stone, table); });
    refused.add_each<UsageError>({"rock.cohesion", "name"}, material_quantity);
    EXPECT_EQ(material_quantity("rock.young_modulus").dimension, Dimension::stress);
    EXPECT_EQ(material_quantity("laboratory.grain_size").dimension, Dimension::length);
}

}  // namespace
}  // namespace graincrack
