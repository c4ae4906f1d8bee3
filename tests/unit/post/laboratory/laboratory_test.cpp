// What a material has of the laboratory, by property.
#include "post/laboratory/laboratory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

LaboratoryProperty property_of(const std::vector<LaboratoryProperty>& all, const std::string& name) {
    for (const LaboratoryProperty& each : all) {
        if (each.name() == name) return each;
    }
    ADD_FAILURE() << "no " << name;
    return {};
}

TEST(LaboratoryProperties, AreTheTargetsOfACalibratedMaterial) {
    const auto all = laboratory_properties(read_material("augig-granite-triangles"), {8e6, 15e6});
    const LaboratoryProperty ucs = property_of(all, "UCS");
    EXPECT_DOUBLE_EQ(ucs.target.value, 122e6);
    EXPECT_NEAR(ucs.target.deviation, 0.05 * 122e6, 1);
    EXPECT_TRUE(ucs.has_own_deviation);
    EXPECT_EQ(name_of(ucs.origin), "fitted");
    EXPECT_DOUBLE_EQ(property_of(all, "σ1 at σ3 = 8 MPa").target.value, 193.5e6);
    const LaboratoryProperty initiation = property_of(all, "crack initiation CI");
    EXPECT_DOUBLE_EQ(initiation.target.deviation, 12e6);
    EXPECT_EQ(name_of(initiation.origin), "predicted");
    EXPECT_EQ(property_of(all, "crack damage CD").target.value, 98e6);
    // No target: the line of [laboratory], UCS + b σ3 with b of 53°.
    const LaboratoryProperty other = property_of(all, "σ1 at σ3 = 15 MPa");
    const double b = (1 + std::sin(53 * M_PI / 180)) / (1 - std::sin(53 * M_PI / 180));
    EXPECT_NEAR(other.target.value, 122e6 + b * 15e6, 1);
    EXPECT_FALSE(other.has_own_deviation);
    EXPECT_EQ(name_of(other.origin), "predicted");
}

TEST(LaboratoryProperties, WithoutTargetsAreThoseOfTheLaboratory) {
    const auto all = laboratory_properties(read_material("augig-granite"), {});
    EXPECT_DOUBLE_EQ(property_of(all, "Brazilian tensile strength").target.value, 8.8e6);
    EXPECT_NEAR(property_of(all, "Poisson's ratio ν").target.deviation, 0.015, 1e-12);
    EXPECT_FALSE(property_of(all, "crack initiation CI").is_measured());
    Material tough = read_material("augig-granite");
    tough.laboratory["mode_i_toughness"] = 1.3e6;
    tough.fitted = {{"mode_i_toughness", "1.3 MPa√m; 1.21 (1.1 to 1.32) on 3 new specimens"}};
    const LaboratoryProperty toughness = property_of(laboratory_properties(tough, {}), "fracture toughness K_IC");
    EXPECT_DOUBLE_EQ(toughness.target.value, 1.3e6);
    EXPECT_DOUBLE_EQ(toughness.target.deviation, 0.13e6);
    EXPECT_EQ(name_of(toughness.origin), "fitted");
    EXPECT_EQ(fitted_entries(tough).front().name, "fracture toughness K_IC");
    EXPECT_EQ(fitted_entries(tough).front().computed, "1.21");
    EXPECT_EQ(name_of(property_of(all, "UCS").origin), "");
    for (const LaboratoryProperty& each : laboratory_properties(std::nullopt, {8e6})) {
        EXPECT_FALSE(each.is_measured()) << each.name();
    }
}

TEST(LaboratoryProperties, ATargetWithoutAnythingToFitIsNoErrorAndAWrongOneIs) {
    const test::TemporaryFolder folder;
    const auto material_with = [&](const std::string& targets) {
        std::ifstream rock(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml");
        std::ofstream(folder.file("rock.toml")) << rock.rdbuf() << "\n[targets]\n" << targets << "\n";
        return read_material(folder.file("rock.toml"));
    };
    const auto all = laboratory_properties(material_with("crack_damage = {value = \"99 MPa\", use = \"predict\"}"), {});
    EXPECT_EQ(name_of(property_of(all, "crack damage CD").origin), "predicted");
    EXPECT_DOUBLE_EQ(property_of(all, "crack damage CD").target.deviation, 9.9e6);
    EXPECT_EQ(name_of(property_of(laboratory_properties(material_with("uniaxial = {value = \"99 MPa\"}"), {}), "UCS").origin),
              "to be fitted");
    test::expect_one_line<InputError>(
        [&] { (void)laboratory_properties(material_with("crack_damage = {vale = \"99 MPa\"}"), {}); }, {"rock.toml", "vale"});
}

TEST(LaboratoryProperties, AreOfTheMaterialThatARunNames) {
    const Material granite = read_material("augig-granite");
    RunHeader header;
    header.material = granite.name;
    header.rock = granite.rock;
    const auto found = [&header](const std::string& name) { return material_of_run(header, name); };
    ASSERT_TRUE(found("augig-granite"));
    EXPECT_EQ(found("augig-granite")->file, granite.file);
    for (const char* name : {"none.toml", "/dev/zero", ""}) EXPECT_FALSE(found(name)) << name;
    header.rock.density += 1;
    EXPECT_FALSE(found("augig-granite"));
}

// A run without temperature keeps no expansions.
TEST(DifferenceFrom, TheMaterialOfARunIsNothing) {
    Material granite = read_material("augig-granite");
    granite.fabric.phases = {{"mica", {}}, {"quartz", {}}};
    granite.fabric.phases["quartz"].thermal_expansion = 8e-6;
    RunSettings run;
    run.material = "Augig granite, as it was before its calibration";
    run.rock = granite.rock;
    run.contact = contact_parameters(granite, run.plane, std::nullopt);
    run.fabric = fabric_of(granite, run.plane, std::nullopt, {"mica", "quartz"});
    run.class_names = {"mica-mica", "mica-quartz", "quartz-quartz"};
    EXPECT_EQ(difference_from(granite, run), "");
    run.fabric.phases = without_expansion(run.fabric.phases);
    EXPECT_EQ(difference_from(granite, run), "");
    run.fabric.phases[0].young_modulus *= 1.01;
    EXPECT_NE(difference_from(granite, run), "");
}

}  // namespace
}  // namespace graincrack
