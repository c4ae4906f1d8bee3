// Crystals of a specimen, and what a file says of those that were asked for and made.
#include "post/run/crystals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "share/file/h5_file.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/synthetic_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

TEST(Crystals, AreGrainsWhereThereAreNone) {
    Specimen s = test::grid_specimen(2, 1, 0.02, 0.01);
    EXPECT_EQ(number_of_crystals(s), 4U);
    EXPECT_EQ(crystal_of(s, 3), 3U);
    std::string labels = grains_label(s) + "\n";
    s.grain_crystal = {0, 0, 1, 1};
    EXPECT_EQ(number_of_crystals(s), 2U);
    EXPECT_EQ(crystal_of(s, 3), 1U);
    test::expect_golden(labels + grains_label(s));
    EXPECT_FALSE(is_within_crystal(s, 0));
    s.contact_kind[0] = static_cast<std::uint8_t>(ContactKind::within_crystal);
    EXPECT_TRUE(is_within_crystal(s, 0));
}

/// A file of a specimen that was made with these settings.
H5Input made_with(const test::TemporaryFolder& folder, Specimen specimen, Settings settings) {
    specimen.settings = std::move(settings);
    H5Output file(folder.file("specimen.h5"), "specimen");
    write_specimen(file, specimen);
    file.commit();
    return H5Input(folder.file("specimen.h5"));
}

TEST(AskedGrains, AreToldBySettings) {
    const test::TemporaryFolder folder;
    const Specimen grid = test::union_jack_grid(2, 2, 1, 1);
    const auto asked = [&](double elongation, const SettingValue& angle, const SettingValue& grade,
                           const SettingValue& material) {
        return asked_grains(made_with(folder, grid,
                                      {{"tessellation", "delaunay"},
                                       {"edge"},
                                       {"grains", 8.0},
                                       {"spread", 0.1},
                                       {"elongation", elongation},
                                       {"elongation_angle", angle, Dimension::angle},
                                       {"grade", grade},
                                       {"material", material}})) +
               "\n";
    };
    test::expect_golden(asked(1, {}, {}, {}) + asked(1.5, std::numbers::pi / 6, {}, "gneiss") + asked(1, {}, "along y", {}));
    EXPECT_EQ(asked_grains(made_with(folder, grid, {})), "");
}

TEST(CrystalSizes, AreMeasured) {
    const test::TemporaryFolder folder;
    // Four triangles to a cell of 0.25 m².
    Specimen blocks = test::crossed_blocks(2, 2, 1, 1, [](int i, int j) { return 2 * j + i; });
    blocks.tessellation = "voronoi";
    auto sizes = crystal_sizes(made_with(folder, blocks, {}));
    ASSERT_TRUE(sizes);
    EXPECT_EQ(sizes->n, 4U);
    EXPECT_NEAR(sizes->mean_diameter, std::sqrt(4 * 0.25 / std::numbers::pi), 1e-15);
    EXPECT_NEAR(sizes->variation, 0, 1e-7);  // the root of a difference at round-off
    EXPECT_EQ(sizes->elements, 4);
    blocks.tessellation = "trigon";
    blocks.grain_crystal = {0, 0, 0, 1};
    sizes = crystal_sizes(made_with(folder, blocks, {}));
    ASSERT_TRUE(sizes);
    EXPECT_EQ(sizes->n, 2U);
    // Areas of 3 : 1 have diameters of √3 : 1, whose coefficient of variation is (√3 − 1)/(√3 + 1).
    EXPECT_NEAR(sizes->variation, (std::sqrt(3) - 1) / (std::sqrt(3) + 1), 1e-14);
    EXPECT_EQ(sizes->elements, 8);
    blocks.tessellation = "imported";
    EXPECT_EQ(crystal_sizes(made_with(folder, blocks, {}))->n, 2U);
    blocks.grain_crystal.clear();
    EXPECT_FALSE(crystal_sizes(made_with(folder, blocks, {})));
}

}  // namespace
}  // namespace graincrack
