#include "post/measure/strength_summary.hpp"

#include <gtest/gtest.h>

#include "post/run/test_label.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

RunData run_of(const std::string& test, double edge, double peak) {
    const test::TemporaryFolder folder;
    test::Recipe recipe;
    recipe.test = test;
    recipe.peak = peak;
    if (test == "brazilian") recipe.plane = PlaneCondition::stress;
    test::write_run(folder.file("run.h5"), recipe);
    RunData run = read_run_data(folder.file("run.h5"));
    run.specimen.mean_edge = edge;
    return run;
}

TEST(GrainSize, RunsOfDifferentSizesAreNotPooled) {
    const std::vector<RunData> runs{run_of("uniaxial", 5.01e-3, 100e6), run_of("brazilian", 5e-3, 8e6),
                                    run_of("uniaxial", 7e-3, 130e6), run_of("uniaxial", 4.98e-3, 110e6)};
    const auto sizes = grain_sizes(runs);
    ASSERT_EQ(sizes.size(), 2U);
    EXPECT_EQ(sizes[0].label, "edge 5 mm");
    EXPECT_EQ(sizes[0].runs, (std::vector<std::size_t>{0, 1, 3}));
    EXPECT_EQ(sizes[1].runs, (std::vector<std::size_t>{2}));
    const auto rows = group_strengths_by_size(runs);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].test, "brazilian");
    EXPECT_EQ(rows[1].size, "edge 5 mm");
    EXPECT_NEAR(rows[1].strength.mean.value, 105e6, 1e6);
    EXPECT_EQ(rows[1].runs, (std::vector<std::size_t>{0, 3}));
    EXPECT_EQ(rows[2].size, "edge 7 mm");
    EXPECT_FALSE(rows[2].ratio_to_brazilian.has_value());  // no disc of that size
    EXPECT_EQ(group_strengths_by_size({runs[0], runs[3]})[0].size, "");
}

TEST(GrainSize, NamesTellRunsApartByWhatDiffers) {
    std::vector<RunData> runs{run_of("uniaxial", 5e-3, 100e6), run_of("uniaxial", 5e-3, 100e6), run_of("uniaxial", 7e-3, 100e6),
                              run_of("tension", 5e-3, 8e6)};
    runs[1].header.contact_law = "other";
    const auto names = names_apart(runs);
    EXPECT_EQ(names[0], "uniaxial, edge 5 mm, law " + runs[0].header.contact_law);
    EXPECT_EQ(names[1], "uniaxial, edge 5 mm, law other");
    EXPECT_EQ(names[2], "uniaxial, edge 7 mm");
    EXPECT_EQ(names[3], "direct tension");
    runs[1] = runs[0];
    runs[0].name = "a/x.h5";
    runs[1].name = "a/y.h5";
    EXPECT_EQ(names_apart({runs[0], runs[1]}), (std::vector<std::string>{"uniaxial, x.h5", "uniaxial, y.h5"}));
}

}  // namespace
}  // namespace graincrack
