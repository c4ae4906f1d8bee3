// What a file says of the grains that were asked for, and of the polygons that were made.
#include "post/run/crystals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "share/file/provenance.hpp"
#include "share/file/specimen.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

/// A file of a specimen that was made with these options.
H5Input made_with(const test::TemporaryFolder& folder, const Specimen& specimen, const std::string& configuration) {
    H5Output file(folder.file("specimen.h5"), "specimen");
    write_specimen(file, specimen);
    Provenance provenance;
    provenance.configuration = configuration;
    write_provenance(file, provenance);
    file.commit();
    return H5Input(folder.file("specimen.h5"));
}

TEST(SpecimenOptions, AreReadFromTheConfigurationOfTheSpecimen) {
    const test::TemporaryFolder folder;
    const Specimen grid = test::union_jack_grid(2, 2, 1, 1);
    const std::string options = "[rectangle]\n# edge =\ngrains = 8\nspread = 0.1\ntessellation = \"delaunay\"\nelongation = ";
    const H5Input plain = made_with(folder, grid, options + "1\nelongation-angle = \"0deg\"\n");
    EXPECT_EQ(asked_grains(plain), "delaunay, grains 8, spread 0.1");
    EXPECT_EQ(specimen_option(plain, "grains"), "8");
    EXPECT_EQ(specimen_option(plain, "edge"), std::nullopt);
    EXPECT_FALSE(crystal_sizes(plain)) << "triangles";
    const H5Input foliated = made_with(folder, grid, options + "1.5\nelongation-angle = \"30deg\"\nmaterial = \"gneiss\"\n");
    EXPECT_EQ(asked_grains(foliated), "delaunay, grains 8, spread 0.1, elongation 1.5, elongation-angle 30deg (material gneiss)");
    const H5Input graded = made_with(folder, grid, options + "1\ngrade = \"along=y,from=0.5,to=2\"\n");
    EXPECT_EQ(asked_grains(graded), "delaunay, grains 8, spread 0.1, grade along=y,from=0.5,to=2");
    EXPECT_EQ(asked_grains(made_with(folder, grid, "grains = = 8")), "") << "no TOML";
    EXPECT_EQ(asked_grains(made_with(folder, grid, "")), "");
}

TEST(SpecimenOptions, PolygonsAreMeasured) {
    const test::TemporaryFolder folder;
    // Four triangles to a cell of 0.25 m².
    Specimen blocks = test::crossed_blocks(2, 2, 1, 1, [](int i, int j) { return 2 * j + i; });
    blocks.tessellation = "voronoi";
    auto sizes = crystal_sizes(made_with(folder, blocks, ""));
    ASSERT_TRUE(sizes);
    EXPECT_EQ(sizes->n, 4U);
    EXPECT_NEAR(sizes->mean_diameter, std::sqrt(4 * 0.25 / std::numbers::pi), 1e-15);
    EXPECT_NEAR(sizes->variation, 0, 1e-7);  // the root of a difference at round-off
    EXPECT_EQ(sizes->elements, 4);
    blocks.tessellation = "trigon";
    blocks.grain_crystal = {0, 0, 0, 1};
    sizes = crystal_sizes(made_with(folder, blocks, ""));
    ASSERT_TRUE(sizes);
    EXPECT_EQ(sizes->n, 2U);
    // Areas of 3 : 1 have diameters of √3 : 1, whose coefficient of variation is (√3 − 1)/(√3 + 1).
    EXPECT_NEAR(sizes->variation, (std::sqrt(3) - 1) / (std::sqrt(3) + 1), 1e-14);
    EXPECT_EQ(sizes->elements, 8);
    blocks.tessellation = "imported";
    EXPECT_EQ(crystal_sizes(made_with(folder, blocks, ""))->n, 2U);
    blocks.grain_crystal.clear();
    EXPECT_FALSE(crystal_sizes(made_with(folder, blocks, "")));
}

}  // namespace
}  // namespace graincrack
