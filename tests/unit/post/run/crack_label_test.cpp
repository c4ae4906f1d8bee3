// What counts as a micro-crack, and which are tensile.
#include "post/run/crack_label.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "post/cracks/crack_counts.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

constexpr CrackLabel by_sign{CrackEvent::failed, CrackModeRule::sign};
constexpr CrackLabel half_damaged{CrackEvent::half_damaged};
constexpr CrackLabel broken{CrackEvent::broken};
constexpr CrackLabel broken_by_sign{CrackEvent::broken, CrackModeRule::sign};
constexpr CrackMoment never;

/// Traction of a point, Pa.
struct Traction {
    double normal, shear;
};
constexpr Traction tension{5, 1};
constexpr Traction pressure{-5, 9};

/// A point that failed at 1 s with a traction and an opening, and lost half of its cohesion and broke later, or never.
Crack crack(const Traction& traction, double opening, const CrackMoment& damaged = never, const CrackMoment& broke = never) {
    Crack c;
    c.time = 1;
    c.opening = opening;
    c.sliding = 7;
    c.mode = opening >= 0 ? CrackMode::tensile : CrackMode::shear;
    c.mode_angle = std::atan2(std::abs(traction.shear), traction.normal);
    c.damaged_50 = damaged;
    c.broken = broke;
    return c;
}

TEST(CrackLabel, ModesByTractionAndBySign) {
    struct Case {
        Traction traction;
        double opening;
        CrackMode by_traction, by_sign;
    };
    constexpr CrackMode tensile = CrackMode::tensile;
    constexpr CrackMode shear = CrackMode::shear;
    for (const Case& at : {Case{{1, 0}, 2, tensile, tensile},     // pure opening
                           Case{{1, 0.99}, 2, tensile, tensile},  // just below 45°
                           Case{{1, 1.01}, 2, shear, tensile}, Case{{1, -1.01}, 2, shear, tensile},
                           Case{{0, 1}, 0, shear, tensile},     // pure sliding while open
                           Case{{1, 0}, -1, shear, shear},      // closed in the step in which it failed
                           Case{{-3, 1}, -1, shear, shear}}) {  // closed
        EXPECT_EQ(mode_of(crack(at.traction, at.opening), {}), at.by_traction) << at.traction.shear;
        EXPECT_EQ(mode_of(crack(at.traction, at.opening), by_sign), at.by_sign) << at.traction.shear;
    }
}

// The traction is that of the peak whatever the event; the sign is that of the event.
TEST(CrackLabel, TheModeOfALaterEvent) {
    const Crack closes = crack(tension, 2, {3, 1, 0}, {4, -1, 0});
    EXPECT_EQ(mode_of(closes, half_damaged), CrackMode::tensile);
    EXPECT_EQ(mode_of(closes, broken), CrackMode::tensile);
    EXPECT_EQ(mode_of(closes, broken_by_sign), CrackMode::shear);
    EXPECT_EQ(mode_of(closes, by_sign), CrackMode::tensile);
    const Crack opens = crack(pressure, -1, {3, -1, 0}, {4, 2, 0});
    EXPECT_EQ(mode_of(opens, broken), CrackMode::shear);
    EXPECT_EQ(mode_of(opens, broken_by_sign), CrackMode::tensile);
    EXPECT_EQ(mode_of(crack(tension, 2, {3, 1, 0}), broken), std::nullopt);
    EXPECT_EQ(mode_of(crack(tension, 2), half_damaged), std::nullopt);
}

// A crack in direct tension that zigzags around grains: facets within 40° of its plane, whose contacts are ten times as soft in
// sliding as in opening. All have slid more than opened as soon as the facet is turned by 6°, yet tension made all of them.
TEST(CrackLabel, AZigzagCrackInDirectTensionIsTensile) {
    constexpr double shear_over_normal_stiffness = 0.1;
    int slid_more = 0;
    for (const double degrees : {-40.0, -25.0, -10.0, 10.0, 25.0, 40.0}) {
        const double turn = degrees * std::numbers::pi / 180;
        const Traction traction{std::cos(turn) * std::cos(turn), std::sin(turn) * std::cos(turn)};
        Crack facet = crack(traction, traction.normal);
        facet.sliding = traction.shear / shear_over_normal_stiffness;
        EXPECT_EQ(mode_of(facet, {}), CrackMode::tensile) << degrees;
        slid_more += std::abs(facet.sliding) > facet.opening ? 1 : 0;
    }
    EXPECT_EQ(slid_more, 6);
}

TEST(CrackLabel, OnlyPointsOfTheEventCountWithItsTimeAndMotion) {
    const std::vector<Crack> log{crack(pressure, -1), crack(tension, 1, {3, 4, 2}, {5, 6, 7})};
    const std::vector<Crack> failed = labelled(log, {});
    ASSERT_EQ(failed.size(), 2U);
    EXPECT_EQ(failed[1].time, 1);
    EXPECT_EQ(failed[1].opening, 1);
    const std::vector<Crack> cracks = labelled(log, half_damaged);
    ASSERT_EQ(cracks.size(), 1U);
    EXPECT_EQ(cracks[0].time, 3);
    EXPECT_EQ(cracks[0].opening, 4);
    EXPECT_EQ(cracks[0].sliding, 2);
    EXPECT_EQ(cracks[0].mode, CrackMode::tensile);
    ASSERT_EQ(labelled(log, broken).size(), 1U);
    EXPECT_EQ(labelled(log, broken)[0].time, 5);
}

TEST(CrackLabel, CountsAreContactsUpToATime) {
    const std::vector<Crack> log{crack(tension, 1, {2, 3, 1}, {3, 3, 1}), crack({1, 2}, 1, {3, -1, 2}, {4, -1, 2}),
                                 crack(pressure, -1)};
    EXPECT_EQ(count_modes(log, {}, 1).tensile, 0.5);
    EXPECT_EQ(count_modes(log, {}, 1).shear, 1);
    EXPECT_EQ(count_modes(log, {}, 0.9).shear, 0);
    EXPECT_EQ(count_modes(log, by_sign, 1).tensile, 1);
    EXPECT_EQ(count_modes(log, half_damaged, 2).tensile, 0.5);
    EXPECT_EQ(count_modes(log, half_damaged, 2).shear, 0);
    EXPECT_EQ(count_modes(log, broken, 4).shear, 0.5);
    Columns<OtherCounts> columns;
    append_other_counts<OtherCounts>(columns, [](const OtherCounts& counts) -> const OtherCounts& { return counts; });
    const std::vector<std::string> names = script_names(columns);
    ASSERT_EQ(names.size(), 6U);
    EXPECT_EQ(names[0], "tensile_cracks_by_sign");
    EXPECT_EQ(names[3], "shear_cracks_broken");
    for (const CrackEvent event : all_crack_events) {
        const std::vector<Cell> cells = cells_of(columns, count_other_labels(log, event, 9));
        EXPECT_EQ(cells[0].text(), event == CrackEvent::failed ? "1" : "0.5");
        EXPECT_EQ(cells[3].text(), "0.5");
    }
}

TEST(CrackLabel, TheDefinitionsDiffer) {
    std::set<std::string> definitions;
    for (const CrackEvent event : all_crack_events) {
        for (const CrackModeRule rule : {CrackModeRule::traction, CrackModeRule::sign}) {
            definitions.insert(definition_of({event, rule}));
        }
    }
    EXPECT_EQ(definitions.size(), 6U);
    EXPECT_EQ(definition_of({}), "cracks: points past their peak; tensile: open, |τ| < σn at the peak");
}

TEST(CrackLabel, WithoutAnEventItIsThatOfTheRun) {
    RunHeader run;
    EXPECT_EQ(CrackLabelChoice{}.of(run), CrackLabel{});
    run.crack_event = CrackEvent::half_damaged;
    EXPECT_EQ(CrackLabelChoice{}.of(run), half_damaged);
    EXPECT_EQ((CrackLabelChoice{CrackEvent::failed, CrackModeRule::sign}).of(run), by_sign);
}

TEST(CrackLabel, TheHistoryOfARunCountsTheCracksOfTheLabel) {
    const test::TemporaryFolder folder;
    test::Recipe recipe;
    std::vector<Crack> cracks = test::synthetic_cracks(recipe.specimen);
    for (std::size_t i = 0; i < 4; ++i) cracks[i].broken = {0.9 + 0.1 * static_cast<double>(i), i == 0 ? 1.0 : -1.0, 0};
    test::write_run(folder.file("run.h5"), recipe, cracks);
    const RunReader run(folder.file("run.h5"));
    const RunData data = run_data(run, {CrackEvent::broken, CrackModeRule::sign});
    const auto& times = data.history[HistoryColumn::time];
    for (std::size_t row = 0; row < times.size(); ++row) {
        EXPECT_EQ(data.history[HistoryColumn::tensile_cracks][row], times[row] >= 0.9 ? 0.5 : 0);
    }
    EXPECT_EQ(data.history[HistoryColumn::shear_cracks].back(), 1.5);
    const auto last = [&](const RunData& of) {
        return of.history[HistoryColumn::tensile_cracks].back() + of.history[HistoryColumn::shear_cracks].back();
    };
    EXPECT_EQ(last(run_data(run)), 0.5 * static_cast<double>(cracks.size()));
    for (std::size_t i = 0; i < 3; ++i) cracks[i].damaged_50 = {0.8, 1, 1};
    recipe.crack_event = CrackEvent::half_damaged;
    test::write_run(folder.file("half.h5"), recipe, cracks);
    EXPECT_EQ(last(run_data(RunReader(folder.file("half.h5")))), 1.5);
}

}  // namespace
}  // namespace graincrack
