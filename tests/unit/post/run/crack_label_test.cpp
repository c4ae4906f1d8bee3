// What counts as a micro-crack, and which are tensile.
#include "post/run/crack_label.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "post/cracks/crack_counts.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

constexpr CrackLabel by_sign{CrackEvent::failed, CrackModeRule::sign};
constexpr CrackLabel half_damaged{CrackEvent::half_damaged};
constexpr CrackLabel broken{CrackEvent::broken};
constexpr CrackLabel broken_by_sign{CrackEvent::broken, CrackModeRule::sign};
constexpr CrackMoment never;

constexpr CrackMode tensile = CrackMode::tensile;
constexpr CrackMode shear = CrackMode::shear;

/// Traction of a point, Pa.
struct Traction {
    double normal, shear;
};
constexpr Traction tension{5, 1};
constexpr Traction pressure{-5, 9};

/// A point that failed at 1 s with a traction and an opening, and lost half of its cohesion and broke later, or never.
Crack crack(const Traction& traction, double opening, const CrackMoment& damaged = never, const CrackMoment& broke = never) {
    return {.time = 1,
            .mode = opening >= 0 ? tensile : shear,
            .mode_angle = std::atan2(std::abs(traction.shear), traction.normal),
            .opening = opening,
            .sliding = 7,
            .damaged_50 = damaged,
            .broken = broke};
}

TEST(CrackLabel, HasAModeByTractionAndBySign) {
    for (const auto& [traction, opening, mode, mode_by_sign] : std::vector<std::tuple<Traction, double, CrackMode, CrackMode>>{
             {{1, 0}, 2, tensile, tensile},     // pure opening
             {{1, 0.99}, 2, tensile, tensile},  // just below 45°
             {{1, 1.01}, 2, shear, tensile},
             {{1, -1.01}, 2, shear, tensile},
             {{0, 1}, 0, shear, tensile},     // pure sliding while open
             {{1, 0}, -1, shear, shear},      // closed in the step in which it failed
             {{-3, 1}, -1, shear, shear}}) {  // closed
        EXPECT_EQ(mode_of(crack(traction, opening), {}), mode) << traction.shear;
        EXPECT_EQ(mode_of(crack(traction, opening), by_sign), mode_by_sign) << traction.shear;
    }
}

// The traction is that of the peak whatever the event; the sign is that of the event.
TEST(CrackLabel, TakesItsSignFromALaterEvent) {
    const Crack closes = crack(tension, 2, {3, 1, 0}, {4, -1, 0});
    EXPECT_EQ(mode_of(closes, half_damaged), tensile);
    EXPECT_EQ(mode_of(closes, broken), tensile);
    EXPECT_EQ(mode_of(closes, broken_by_sign), shear);
    EXPECT_EQ(mode_of(closes, by_sign), tensile);
    const Crack opens = crack(pressure, -1, {3, -1, 0}, {4, 2, 0});
    EXPECT_EQ(mode_of(opens, broken), shear);
    EXPECT_EQ(mode_of(opens, broken_by_sign), tensile);
    EXPECT_EQ(mode_of(crack(tension, 2, {3, 1, 0}), broken), std::nullopt);
    EXPECT_EQ(mode_of(crack(tension, 2), half_damaged), std::nullopt);
}

// A crack in direct tension that zigzags around grains: facets within 40° of its plane, whose contacts are ten times as soft in
// sliding as in opening. All have slid more than opened as soon as the facet is turned by 6°, yet tension made all of them.
TEST(CrackLabel, IsTensileOnAZigzagCrackInDirectTension) {
    constexpr double shear_over_normal_stiffness = 0.1;
    int slid_more = 0;
    for (const double degrees : {-40.0, -25.0, -10.0, 10.0, 25.0, 40.0}) {
        const double turn = degrees * std::numbers::pi / 180;
        const Traction traction{std::cos(turn) * std::cos(turn), std::sin(turn) * std::cos(turn)};
        Crack facet = crack(traction, traction.normal);
        facet.sliding = traction.shear / shear_over_normal_stiffness;
        EXPECT_EQ(mode_of(facet, {}), tensile) << degrees;
        slid_more += std::abs(facet.sliding) > facet.opening ? 1 : 0;
    }
    EXPECT_EQ(slid_more, 6);
}

TEST(CrackLabel, CountsPointsOfItsEventWithTheirTimeAndMotion) {
    const std::vector<Crack> log{crack(pressure, -1), crack(tension, 1, {3, 4, 2}, {5, 6, 7})};
    EXPECT_EQ(labelled(log, {}).size(), 2U);
    const auto expect_last = [&](const CrackLabel& label, double time, double opening, double sliding) {
        const Crack last = labelled(log, label).back();
        EXPECT_EQ(std::tie(last.time, last.opening, last.sliding, last.mode), std::tie(time, opening, sliding, tensile));
    };
    expect_last({}, 1, 1, 7);
    for (const CrackLabel& label : {half_damaged, broken}) EXPECT_EQ(labelled(log, label).size(), 1U);
    expect_last(half_damaged, 3, 4, 2);
    expect_last(broken, 5, 6, 7);
}

TEST(CrackLabel, CountsContactsUpToATime) {
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
    EXPECT_EQ(script_names(columns),
              (std::vector<std::string>{"tensile_cracks_by_sign", "shear_cracks_by_sign", "tensile_cracks_broken",
                                        "shear_cracks_broken", "tensile_cracks_broken_by_sign", "shear_cracks_broken_by_sign"}));
    for (const CrackEvent event : all_crack_events) {
        const std::vector<Cell> cells = cells_of(columns, count_other_labels(log, event, 9));
        EXPECT_EQ(cells[0].text(), event == CrackEvent::failed ? "1" : "0.5");
        EXPECT_EQ(cells[3].text(), "0.5");
    }
}

TEST(CrackLabel, IsDefinedInWords) {
    std::string definitions;
    for (const CrackEvent event : all_crack_events) {
        for (const CrackModeRule rule : {CrackModeRule::traction, CrackModeRule::sign}) {
            definitions += definition_of({event, rule}) + "\n";
        }
    }
    test::expect_golden(definitions);
}

TEST(CrackLabel, IsThatOfTheRunWithoutAnEvent) {
    RunHeader run;
    EXPECT_EQ(CrackLabelChoice{}.of(run), CrackLabel{});
    run.crack_event = CrackEvent::half_damaged;
    EXPECT_EQ(CrackLabelChoice{}.of(run), half_damaged);
    EXPECT_EQ((CrackLabelChoice{CrackEvent::failed, CrackModeRule::sign}).of(run), by_sign);
}

TEST(CrackLabel, CountsTheCracksOfTheHistoryOfARun) {
    const test::TemporaryFolder folder;
    std::vector<Crack> cracks = test::synthetic_cracks(test::Recipe{}.specimen);
    for (std::size_t i = 0; i < 4; ++i) cracks[i].broken = {0.9 + 0.1 * static_cast<double>(i), i == 0 ? 1.0 : -1.0, 0};
    test::write_run(folder.file("run.h5"), {}, cracks);
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
    test::write_run(folder.file("half.h5"), {.crack_event = CrackEvent::half_damaged}, cracks);
    EXPECT_EQ(last(run_data(RunReader(folder.file("half.h5")))), 1.5);
}

}  // namespace
}  // namespace graincrack
