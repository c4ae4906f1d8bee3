// What counts as a micro-crack, and which are tensile.
#include "post/cracks/crack_label.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "post/cracks/crack_counts.hpp"
#include "synthetic_run.hpp"

namespace graincrack {
namespace {

constexpr CrackLabel failed_by_displacement{CrackEvent::failed, CrackModeRule::displacement};
constexpr CrackLabel broken{CrackEvent::broken, CrackModeRule::sign};
constexpr CrackLabel broken_by_displacement{CrackEvent::broken, CrackModeRule::displacement};

/// A point that failed at 1 s and, unless `time_broken` is NaN, broke.
Crack crack(double opening, double sliding, double time_broken = std::nan(""), double opening_broken = std::nan(""),
            double sliding_broken = std::nan("")) {
    Crack c;
    c.time = 1;
    c.opening = opening;
    c.sliding = sliding;
    c.mode = opening >= 0 ? CrackMode::tensile : CrackMode::shear;
    c.time_broken = time_broken;
    c.opening_broken = opening_broken;
    c.sliding_broken = sliding_broken;
    return c;
}

TEST(CrackLabel, ModesBySignAndByDisplacement) {
    struct Case {
        double opening, sliding;
        CrackMode by_sign, by_displacement;
    };
    for (const Case& at : {Case{2, 1, CrackMode::tensile, CrackMode::tensile},
                           Case{2, -1, CrackMode::tensile, CrackMode::tensile}, Case{1, 2, CrackMode::tensile, CrackMode::shear},
                           Case{1, -2, CrackMode::tensile, CrackMode::shear}, Case{0, 1, CrackMode::tensile, CrackMode::shear},
                           Case{-2, 1, CrackMode::shear, CrackMode::shear}, Case{-1, -2, CrackMode::shear, CrackMode::shear}}) {
        EXPECT_EQ(mode_of(crack(at.opening, at.sliding), {}), at.by_sign);
        EXPECT_EQ(mode_of(crack(at.opening, at.sliding), failed_by_displacement), at.by_displacement);
        const Crack later = crack(-1, 5, 3, at.opening, at.sliding);
        EXPECT_EQ(mode_of(later, broken), at.by_sign);
        EXPECT_EQ(mode_of(later, broken_by_displacement), at.by_displacement);
        EXPECT_EQ(mode_of(later, {}), CrackMode::shear);
    }
}

TEST(CrackLabel, FailedBySignIsTheLogAsItIs) {
    const std::vector<Crack> log{crack(1, 2), crack(-1, 2, 3, 1, 2)};
    const std::vector<Crack> cracks = labelled(log, {});
    ASSERT_EQ(cracks.size(), 2U);
    for (std::size_t i = 0; i < cracks.size(); ++i) {
        EXPECT_EQ(cracks[i].time, 1);
        EXPECT_EQ(cracks[i].opening, log[i].opening);
        EXPECT_EQ(cracks[i].mode, log[i].mode);
    }
}

TEST(CrackLabel, OnlyBrokenPointsAreBrokenWithTheirOwnTimeAndMotion) {
    const std::vector<Crack> cracks = labelled({crack(1, 2), crack(-1, 2, 3, 4, 2)}, broken_by_displacement);
    ASSERT_EQ(cracks.size(), 1U);
    EXPECT_EQ(cracks[0].time, 3);
    EXPECT_EQ(cracks[0].opening, 4);
    EXPECT_EQ(cracks[0].sliding, 2);
    EXPECT_EQ(cracks[0].mode, CrackMode::tensile);
}

TEST(CrackLabel, CountsAreContactsUpToATime) {
    const std::vector<Crack> log{crack(1, 2, 2, 3, 1), crack(-1, 2, 4, -1, 2), crack(-1, 2)};
    EXPECT_EQ(count_modes(log, {}, 1).tensile, 0.5);
    EXPECT_EQ(count_modes(log, {}, 1).shear, 1);
    EXPECT_EQ(count_modes(log, {}, 0.9).shear, 0);
    EXPECT_EQ(count_modes(log, failed_by_displacement, 1).tensile, 0);
    EXPECT_EQ(count_modes(log, broken, 3).tensile, 0.5);
    EXPECT_EQ(count_modes(log, broken, 3).shear, 0);
    EXPECT_EQ(count_modes(log, broken, 4).shear, 0.5);
    const std::vector<Cell> cells = label_cells(log, 9);
    ASSERT_EQ(cells.size(), label_columns().size());
    EXPECT_EQ(label_columns()[2], "tensile_cracks_broken");
    EXPECT_EQ(cells[2].text(), "0.5");
}

TEST(CrackLabel, TheDefinitionsDiffer) {
    std::set<std::string> definitions;
    for (const CrackLabel& label : all_crack_labels) definitions.insert(definition_of(label));
    EXPECT_EQ(definitions.size(), 4U);
    EXPECT_EQ(definition_of({}), "cracks: points past their peak; tensile: open then");
}

TEST(CrackLabel, TheHistoryOfARunCountsTheCracksOfTheLabel) {
    const test::TemporaryFolder folder;
    test::Recipe recipe;
    std::vector<Crack> cracks = test::synthetic_cracks(recipe.specimen);
    for (std::size_t i = 0; i < 4; ++i) {
        cracks[i].time_broken = 0.9 + 0.1 * static_cast<double>(i);
        cracks[i].opening_broken = i == 0 ? 1 : -1;
        cracks[i].sliding_broken = 0;
    }
    test::write_run(folder.file("run.h5"), recipe, cracks);
    const RunReader run(folder.file("run.h5"));
    const RunData as_written = read_labelled_run(run, {});
    EXPECT_EQ(as_written.history.columns, run_data(run).history.columns);
    const RunData data = read_labelled_run(run, broken);
    const auto& times = data.history[HistoryColumn::time];
    for (std::size_t row = 0; row < times.size(); ++row) {
        EXPECT_EQ(data.history[HistoryColumn::tensile_cracks][row], times[row] >= 0.9 ? 0.5 : 0);
    }
    EXPECT_EQ(data.history[HistoryColumn::shear_cracks].back(), 1.5);
}

}  // namespace
}  // namespace graincrack
