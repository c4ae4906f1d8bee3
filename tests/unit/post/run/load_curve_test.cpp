#include "post/run/load_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

RunData data_of(const test::Recipe& recipe) {
    const Specimen& s = recipe.specimen;
    const SpecimenSummary specimen{s.width, s.height, 7, static_cast<std::int64_t>(s.n_grains()), 0.005};
    return {"run.h5", test::synthetic_header(recipe), test::synthetic_history(recipe), specimen};
}

TEST(LoadCurve, IsPositiveInCompressionAndPeaksWherePlanted) {
    const LoadCurve curve = load_curve(data_of({}));
    EXPECT_EQ(curve.start, 0U);
    EXPECT_EQ(curve.peak, 100U);
    EXPECT_NEAR(curve.stress[curve.peak], 125e6, 1);
    EXPECT_EQ(curve.peak_stress(), curve.strength->stress);  // of the smoothed curve
    EXPECT_EQ(curve.shown_stress(curve.peak), curve.peak_stress());
    EXPECT_EQ(curve.shown_stress(curve.peak - 20), curve.stress[curve.peak - 20]);
    EXPECT_GT(curve.axial_strain[curve.peak], 0);
    EXPECT_GT(curve.lateral_strain[curve.peak], 0);  // widens
}

TEST(LoadCurve, ReachesHalfThePeakBetweenRows) {
    const LoadCurve curve = load_curve(data_of({.rows = 100}));  // 99 steps: half the peak falls between rows 49 and 50
    const CurvePoint half = half_peak(curve);
    EXPECT_NE(half.share, 0);
    EXPECT_NEAR(half.of(curve.stress), 62.5e6, 1);
    EXPECT_NEAR(half.of(curve.gauge_axial_strain), 62.5e6 / 26e9, 1e-12);
}

TEST(LoadCurve, BeginsBehindTheIsotropicStage) {
    const LoadCurve curve = load_curve(data_of({.test = "triaxial", .confining_pressure = 4e6}));
    EXPECT_EQ(curve.start, 10U);
    EXPECT_NEAR(curve.start_stress(), 4e6, 1);
    EXPECT_NEAR(half_peak(curve).of(curve.stress), (4e6 + 125e6) / 2, 1);
}

TEST(LoadCurve, YieldsWhereTheOffsetIsReachedUnlessItIsBrittle) {
    // Beyond a share of 0.7 the tangent is E/2: the platen strain departs from the chord by 1.02 (σ − σy)/E.
    const auto yield = first_yield(load_curve(data_of({.yield_share = 0.7})));
    ASSERT_TRUE(yield.has_value());
    EXPECT_NEAR(*yield, 0.7 * 125e6 + yield_offset * 26e9 / 1.02, 1e3);
    EXPECT_FALSE(first_yield(load_curve(data_of({}))).has_value());
}

TEST(LoadCurve, HasAPeakOfAKind) {
    for (const auto& [drop, stop_reason, kind] : std::vector<std::tuple<double, std::string, std::string>>{
             {0.5, "peak drop", "drop"},
             {0.5, "strain limit", "drop"},  // fell by half: there was a peak
             {0.051, "strain limit", "drop"},
             {0.049, "strain limit", "cap"},
             {0, "strain limit", "cap"},
             {0, "signal", ""}}) {
        const RunData run = data_of({.drop = drop, .stop_reason = stop_reason});
        EXPECT_EQ(peak_kind(run.header, load_curve(run).strength.has_value()), kind) << stop_reason << drop;
    }
}

TEST(LoadCurve, NeedsAHistoryOfATest) {
    test::GoldenRefusals refused;
    const auto refuse = [&](const std::string& what, auto change) {
        RunData run = data_of({});
        change(run);
        refused.add<InputError>(what, [&] { (void)load_curve(run); });
    };
    refuse("no number", [](RunData& run) { run.history[HistoryColumn::axial_stress][42] = std::nan(""); });
    refuse("infinite", [](RunData& run) { run.history[HistoryColumn::axial_strain][7] = HUGE_VAL; });
    refuse("two rows", [](RunData& run) {
        for (auto& column : run.history.columns) column.resize(2);
    });
    refuse("pulled in compression", [](RunData& run) {
        for (double& stress : run.history[HistoryColumn::axial_stress]) stress = -stress;
    });
    refuse("never left the isotropic stage", [](RunData& run) { run.header.isotropic_end_time = 99; });
}

}  // namespace
}  // namespace graincrack
