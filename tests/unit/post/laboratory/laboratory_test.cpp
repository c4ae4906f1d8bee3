// What a material has of the laboratory, by property.
#include "post/laboratory/laboratory.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

std::string text_of(const std::vector<LaboratoryProperty>& all) {
    std::string text;
    for (const LaboratoryProperty& each : all) {
        const calibrate::Target& target = each.target;
        text += fmt::format("{}: {}", each.name(), each.is_measured() ? target.text(target.value) : "not measured");
        if (target.deviation > 0) text += " ± " + target.text(target.deviation);
        if (each.has_own_deviation) text += " of its own";
        if (each.origin != PropertyOrigin::unknown) text += ", " + name_of(each.origin);
        text += "\n";
    }
    return text;
}

TEST(LaboratoryProperties, AreTheTargetsOfACalibratedMaterial) {
    const auto all = laboratory_properties(read_material("augig-granite-triangles"), {8e6, 15e6});
    test::expect_golden(text_of(all));
    // No target: the line of [laboratory], UCS + b σ3 with b of 53°.
    const double b = (1 + std::sin(53 * M_PI / 180)) / (1 - std::sin(53 * M_PI / 180));
    const auto confined = std::ranges::find(all, "σ1 at σ3 = 15 MPa", &LaboratoryProperty::name);
    EXPECT_NEAR(confined->target.value, 122e6 + b * 15e6, 1);
}

TEST(LaboratoryProperties, AreThoseOfTheLaboratoryWithoutTargets) {
    Material granite = read_material("augig-granite");
    test::expect_golden(text_of(laboratory_properties(granite, {})));
    granite.laboratory["mode_i_toughness"] = 1.3e6;
    granite.fitted = {{"mode_i_toughness", "1.3 MPa√m; 1.21 (1.1 to 1.32) on 3 new specimens"}};
    const auto fitted = fitted_entries(granite).front();
    test::expect_golden(text_of(laboratory_properties(granite, {})) + fitted.name + " " + fitted.computed, "with fitted K_IC");
    test::expect_golden(text_of(laboratory_properties(std::nullopt, {8e6})), "no material");
}

TEST(LaboratoryProperties, NeedNoTargetToFitButKnownKeys) {
    const test::TemporaryFolder folder;
    const auto with = [&](const std::string& targets) {
        std::ifstream rock(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml");
        std::ofstream(folder.file("rock.toml")) << rock.rdbuf() << "\n[targets]\n" << targets << "\n";
        return laboratory_properties(read_material(folder.file("rock.toml")), {});
    };
    test::expect_golden(text_of(with("crack_damage = {value = \"99 MPa\", use = \"predict\"}")), "predicted");
    test::expect_golden(text_of(with("uniaxial = {value = \"99 MPa\"}")), "fitted");
    test::GoldenRefusals("refusals").add<InputError>("wrong key", [&] { with("crack_damage = {vale = \"99 MPa\"}"); });
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
TEST(DifferenceFrom, IsNothingForTheMaterialOfARun) {
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
