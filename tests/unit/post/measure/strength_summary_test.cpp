#include "post/measure/strength_summary.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "post/run/comparability.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

RunData run_of(const std::string& test, double diameter, double peak) {
    const test::TemporaryFolder folder;
    test::Recipe recipe;
    recipe.test = test;
    recipe.peak = peak;
    if (test == "brazilian") recipe.plane = PlaneCondition::stress;
    test::write_run(folder.file("run.h5"), recipe);
    RunData run = read_run_data(folder.file("run.h5"));
    run.specimen.grain_diameter = diameter;
    return run;
}

TEST(StrengthGroups, RunsOfDifferentSizesAreNotPooled) {
    const std::vector<RunData> runs{run_of("uniaxial", 5.01e-3, 100e6), run_of("brazilian", 5e-3, 8e6),
                                    run_of("uniaxial", 7e-3, 130e6), run_of("uniaxial", 4.98e-3, 110e6)};
    const auto rows = group_strengths(runs);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].test, "brazilian");
    EXPECT_EQ(rows[1].distinction, "grain diameter 5 mm");
    EXPECT_NEAR(rows[1].strength.mean.value, 105e6, 1e6);
    EXPECT_EQ(rows[1].runs, (std::vector<std::size_t>{0, 3}));
    EXPECT_EQ(rows[2].distinction, "grain diameter 7 mm");
    EXPECT_FALSE(rows[2].ratio_to_brazilian.has_value());  // no disc of that size
    EXPECT_EQ(group_strengths({runs[0], runs[3]})[0].distinction, "");
}

TEST(StrengthGroups, NamesTellRunsApartByWhatDiffers) {
    std::vector<RunData> runs{run_of("uniaxial", 5e-3, 100e6), run_of("uniaxial", 5e-3, 100e6), run_of("uniaxial", 7e-3, 100e6),
                              run_of("tension", 5e-3, 8e6)};
    runs[1].header.contact_law = "other";
    const auto names = names_apart(runs);
    EXPECT_EQ(names[0], "uniaxial, contact law literal, grain diameter 5 mm");
    EXPECT_EQ(names[1], "uniaxial, contact law other, grain diameter 5 mm");
    EXPECT_EQ(names[2], "uniaxial, contact law literal, grain diameter 7 mm");
    EXPECT_EQ(names[3], "direct tension");
    runs[1] = runs[0];
    runs[0].name = "a/x.h5";
    runs[1].name = "a/y.h5";
    EXPECT_EQ(names_apart({runs[0], runs[1]}), (std::vector<std::string>{"uniaxial, x.h5", "uniaxial, y.h5"}));
}

TEST(StrengthSummary, HasARowForEachGroupAndCountsATestOnce) {
    const test::TemporaryFolder folder;
    test::Recipe recipe;
    test::write_run(folder.file("a.h5"), recipe);
    test::write_run(folder.file("same.h5"), recipe);
    recipe.specimen = test::grid_specimen(16, 16, 0.16, 0.16);
    test::write_run(folder.file("wide.h5"), recipe);
    std::ostringstream out, notes;
    write_strength_summary(out, {folder.file("a.h5"), folder.file("same.h5"), folder.file("wide.h5")}, TableFormat::tsv, notes);
    EXPECT_EQ(test::parse_tsv(out.str()).size(), 3U) << out.str();
    EXPECT_EQ(test::field(out.str(), "runs"), "1");
    EXPECT_EQ(test::field(out.str(), "differs_in"), "width 80 mm");
    EXPECT_EQ(test::field(out.str(), "differs_in", 1), "width 160 mm");
    EXPECT_NE(notes.str().find("counts once"), std::string::npos);
}

}  // namespace
}  // namespace graincrack
