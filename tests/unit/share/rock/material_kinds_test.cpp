// Kinds of rock: what a material of one's own begins with.

#include <gtest/gtest.h>

#include <fstream>
#include <tuple>

#include "share/base/error.hpp"
#include "share/rock/material.hpp"
#include "share/rock/material_edit.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

const std::vector<MaterialSetting> measured{{"laboratory.young_modulus", "60 GPa"},
                                            {"laboratory.poisson_ratio", "0.2"},
                                            {"laboratory.density", "2700 kg/m3"},
                                            {"laboratory.tensile_strength", "9 MPa"},
                                            {"laboratory.compressive_strength", "150MPa"},
                                            {"laboratory.friction_angle", "50 deg"},
                                            {"laboratory.grain_size", "3 mm"},
                                            {"laboratory.mode_i_toughness", "1.4 MPa.m^0.5"},
                                            {"laboratory.crack_initiation", "60 MPa"},
                                            {"laboratory.crack_damage", "110 MPa"}};

/// Those that are a rock.
std::vector<RockKind> kinds() {
    std::vector<RockKind> all = rock_kinds();
    EXPECT_EQ(all.back().name, every_key);
    all.pop_back();
    return all;
}

TEST(RockKinds, AreThereWithADescription) {
    std::string text;
    for (const RockKind& kind : kinds()) text += kind.name + ": " + kind.description + "\n";
    test::Refusals refused;
    refused.add<UsageError>("granit", [] { std::ignore = material_of_kind("granit", "x"); });
    test::expect_golden(text + refused.text());
}

TEST(RockKinds, NeedLaboratoryValuesAlone) {
    const test::TemporaryFolder folder;
    for (const RockKind& kind : kinds()) {
        const std::string file = folder.file(kind.name + ".toml");
        std::ofstream(file) << material_of_kind(kind.name, "stone");
        const IncompleteMaterial bare = read_incomplete_material(file);
        for (const std::string& key : bare.missing) EXPECT_TRUE(key.starts_with("rock.") || key == "fabric.grain_size") << key;
        std::ofstream(file) << new_material(kind.name, "stone", measured);
        const Material rock = read_material(file);
        EXPECT_EQ(rock.name, "stone");
        EXPECT_EQ(rock.law, "cohesive-frictional");
        EXPECT_EQ(rock.grains.tessellation, "trigon");
        EXPECT_EQ(rock.grains.grain_size, 3e-3);
        EXPECT_EQ(rock.rock.mode_i_toughness, 1.4e6);
        double fractions = 0, mean = 0;
        for (const auto& [name, phase] : rock.fabric.phases) {
            fractions += phase.fraction;
            mean += phase.fraction * relative_young_modulus(phase, rock.rock);
        }
        EXPECT_NEAR(fractions, 1, 1e-12) << kind.name;
        EXPECT_NEAR(mean, 1, 1e-3) << kind.name;  // so that the grains are as stiff as the rock on average
        const ContactParameters p = contact_parameters(rock, PlaneCondition::strain, std::nullopt);
        EXPECT_NEAR(p.cohesion / p.tensile_strength, *rock.ratios.cohesion, 1e-12);
        EXPECT_NEAR(60e9 * p.fracture_energy / (p.tensile_strength * p.tensile_strength * 3e-3), *rock.ratios.fracture_energy,
                    1e-12);
    }
}

// Above the line behind which nothing need be changed are the values to enter and no others.
TEST(RockKinds, BeginWithWhatIsToBeEntered) {
    for (const RockKind& kind : kinds()) {
        const std::string head = kind.text.substr(0, kind.text.find("What follows need not be changed"));
        ASSERT_LT(head.size(), kind.text.size()) << kind.name;
        const std::string needed = head.substr(0, head.find("# Where known"));
        std::size_t entries = 1;  // its name
        for (std::size_t at = needed.find("\n# "); at != std::string::npos; at = needed.find("\n# ", at + 1)) ++entries;
        EXPECT_LE(entries, 10U) << kind.name;
        for (const auto& [key, value] : measured) EXPECT_NE(head.find("# " + key.substr(11) + " = "), std::string::npos) << key;
    }
}

}  // namespace
}  // namespace graincrack
