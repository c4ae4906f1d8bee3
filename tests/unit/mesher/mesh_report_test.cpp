#include "mesher/mesh_report.hpp"

#include <gtest/gtest.h>

#include "mesher/fabric/crystals.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

/// Triangles with contacts of 1 to 1.41 mm, of two phases.
Specimen two_phases() {
    Specimen s = test::one_diagonal_grid(4, 4, 4e-3, 4e-3);
    s.phase_names = {"quartz", "mica"};
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = g < s.n_grains() / 2 ? 0 : 1;
    return s;
}

TEST(ContactZones, AreThoseOfTheMaterial) {
    Material material = test::augig_granite();
    test::expect_golden(text_of(describe_zones(material, two_phases())), "(9 pi/32) (K_IC/tc)² of 87 J/m²");
    material.contact.fracture_energy = 20;
    test::expect_golden(text_of(describe_zones(material, two_phases())), "20 J/m²");
}

TEST(ContactZones, AreOfThePairAndOfTheCrystalsThatHaveTheShortest) {
    Material material = test::augig_granite();
    material.fabric.phases["quartz"].fraction = material.fabric.phases["mica"].fraction = 0.5;
    material.fabric.pairs["quartz-mica"].fracture_energy = 10;
    material.fabric.within.fracture_energy = 0.2;
    Specimen s = two_phases();
    std::vector<int> crystals;
    for (std::size_t g = 0; g < s.n_grains(); ++g) crystals.push_back(static_cast<int>(g / 4));
    name_crystals(s, crystals);
    test::expect_golden(text_of(describe_zones(material, s)));
    s.phase_names = {"quartz", "biotite"};
    EXPECT_TRUE(describe_zones(material, s).empty()) << "another material";
}

TEST(MeshReport, WarnsOfCrystalsBetweenNarrowWallsAsOfTriangles) {
    const auto compare_report = [](const std::string& what, double angle, double area_error, std::size_t n_flaws) {
        Specimen s = two_phases();
        s.statistics.min_angle = angle;
        const Request request{.region = rectangle(4e-3, 4e-3), .fabric = {.tessellation = Tessellation::trigon}};
        const MeshReport report{.largest_area_error = area_error, .n_flaws = n_flaws};
        test::expect_golden(text_of(describe_mesh(s, request, report)), what);
    };
    compare_report("a flaw", 0.2, 0.04, 1);
    compare_report("a flaw near another", 0.007, 0.1, 1);
    compare_report("elongated crystals", 0.007, 0, 0);
}

TEST(MeshReport, NamesWhatWasNotReached) {
    const Specimen s = two_phases();
    const Request request{.region = rectangle(4e-3, 4e-3), .fabric = {.spread = 0.01}};
    const MeshReport report{.spread = 0.1, .psi6_of_parts = 0.5, .attempts = 20};
    test::expect_golden(text_of(describe_mesh(s, request, report)));
}

}  // namespace
}  // namespace graincrack::mesher
