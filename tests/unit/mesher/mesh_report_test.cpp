#include <gtest/gtest.h>

#include "mesher/fabric/crystals.hpp"
#include "mesher/mesh_report.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::mesher {
namespace {

Material augig_granite() {
    Material material;
    material.name = "Augig granite";
    material.rock = {25.8e9, 0.23, 2650, 1.5e6, 3.0e6, 8.8e6};
    material.contact.tensile_strength = 24.15e6;
    return material;
}

/// Triangles with contacts of 1 to 1.41 mm, of two phases.
Specimen two_phases() {
    Specimen s = test::one_diagonal_grid(4, 4, 4e-3, 4e-3);
    s.phase_names = {"quartz", "mica"};
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = g < s.n_grains() / 2 ? 0 : 1;
    return s;
}

bool is_warning(const Remark& line) { return !line.code.empty(); }

TEST(ContactZones, AreThoseOfTheMaterial) {
    Material material = augig_granite();
    const auto lines = describe_zones(material, two_phases());  // (9 pi/32) (K_IC/tc)²
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NE(lines[0].text.find("elements a contact zone between crystals, 3.41 mm long"), std::string::npos) << lines[0].text;
    EXPECT_FALSE(is_warning(lines[0]));
    material.contact.fracture_energy = 20;  // of 87 J/m²
    const auto brittle = describe_zones(material, two_phases());
    ASSERT_EQ(brittle.size(), 1U);
    EXPECT_TRUE(is_warning(brittle[0]));
    EXPECT_NE(brittle[0].text.find(" 782 um long: with fewer than one"), std::string::npos) << brittle[0].text;
}

TEST(Crystals, AreWarnedOfBetweenNarrowWallsAsTrianglesAre) {
    const auto warned = [](double angle, double area_error, std::size_t n_flaws) {
        Specimen s = two_phases();
        s.statistics.min_angle = angle;
        Request request;
        request.region = rectangle(4e-3, 4e-3);
        request.fabric.tessellation = Tessellation::trigon;
        MeshReport report;
        report.largest_area_error = area_error;
        report.n_flaws = n_flaws;
        std::vector<std::string> codes;
        for (const Remark& line : describe_mesh(s, request, report)) {
            if (is_warning(line) && line.code != "few_crystals") codes.push_back(line.code);
        }
        return codes;
    };
    EXPECT_EQ(warned(0.2, 0.04, 1), std::vector<std::string>());
    EXPECT_EQ(warned(0.007, 0.1, 1), (std::vector<std::string>{"missed_areas", "small_angle"}));
    EXPECT_EQ(warned(0.1, 0, 0), std::vector<std::string>()) << "elongated";
}

TEST(ContactZones, TheShortestOfPairsAndOfCrystalsIsToldOnce) {
    Material material = augig_granite();
    material.fabric.phases["quartz"].fraction = material.fabric.phases["mica"].fraction = 0.5;
    material.fabric.pairs["quartz-mica"].fracture_energy = 10;
    material.fabric.within.fracture_energy = 0.2;
    Specimen s = two_phases();
    std::vector<int> crystals;
    for (std::size_t g = 0; g < s.n_grains(); ++g) crystals.push_back(static_cast<int>(g / 4));
    name_crystals(s, crystals);
    const auto lines = describe_zones(material, s);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_TRUE(is_warning(lines[0]) && lines[0].text.find("of quartz-mica") != std::string::npos) << lines[0].text;
    EXPECT_FALSE(is_warning(lines[1])) << lines[1].text;
    EXPECT_NE(lines[1].text.find("zone within crystals, "), std::string::npos) << lines[1].text;
    s.phase_names = {"quartz", "biotite"};
    EXPECT_TRUE(describe_zones(material, s).empty()) << "another material";
}

}  // namespace
}  // namespace graincrack::mesher
