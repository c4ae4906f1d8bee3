#include "post/run/load_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

using test::Recipe;

RunData data_of(const Recipe& recipe) {
    RunData run;
    run.name = "run.h5";
    run.header = test::synthetic_header(recipe);
    run.history = test::synthetic_history(recipe);
    run.specimen = {recipe.specimen.width, recipe.specimen.height, 7, static_cast<std::int64_t>(recipe.specimen.n_grains()),
                    0.005};
    return run;
}

TEST(LoadCurve, CompressionIsPositiveAndPeaksWherePlanted) {
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

TEST(LoadCurve, HalfPeakLiesBetweenRows) {
    Recipe recipe;
    recipe.rows = 100;  // 99 steps: half the peak falls between rows 49 and 50
    const LoadCurve curve = load_curve(data_of(recipe));
    const CurvePoint half = half_peak(curve);
    EXPECT_NE(half.share, 0);
    EXPECT_NEAR(half.of(curve.stress), 62.5e6, 1);
    EXPECT_NEAR(half.of(curve.gauge_axial_strain), 62.5e6 / 26e9, 1e-12);
}

TEST(LoadCurve, TriaxialStartsAfterTheIsotropicStage) {
    Recipe recipe;
    recipe.test = "triaxial";
    recipe.confining_pressure = 4e6;
    const LoadCurve curve = load_curve(data_of(recipe));
    EXPECT_EQ(curve.start, 10U);
    EXPECT_NEAR(curve.start_stress(), 4e6, 1);
    EXPECT_NEAR(half_peak(curve).of(curve.stress), (4e6 + 125e6) / 2, 1);
}

TEST(LoadCurve, FirstYieldIsWhereTheOffsetIsReached) {
    Recipe recipe;
    recipe.yield_share = 0.7;  // beyond it the tangent is E/2: the platen strain departs from the chord by 1.02 (σ − σy)/E
    const RunData run = data_of(recipe);
    const auto yield = first_yield(load_curve(run));
    ASSERT_TRUE(yield.has_value());
    EXPECT_NEAR(*yield, 0.7 * 125e6 + yield_offset * 26e9 / 1.02, 1e3);
}

TEST(LoadCurve, BrittleCurveHasNoYield) { EXPECT_FALSE(first_yield(load_curve(data_of({}))).has_value()); }

TEST(LoadCurve, NumbersThatAreNoneAreOneLine) {
    RunData run = data_of({});
    run.history[HistoryColumn::axial_stress][42] = std::nan("");
    test::expect_one_line<InputError>([&] { (void)load_curve(run); }, {"run.h5", "row 42 of /history"});
    run = data_of({});
    run.history[HistoryColumn::axial_strain][7] = HUGE_VAL;
    test::expect_one_line<InputError>([&] { (void)load_curve(run); }, {"row 7"});
}

TEST(LoadCurve, PeakKindTellsDropFromCap) {
    Recipe recipe;
    const auto kind = [&] {
        const RunData run = data_of(recipe);
        return peak_kind(run.header, load_curve(run).strength.has_value());
    };
    EXPECT_EQ(kind(), "drop");
    recipe.stop_reason = "strain limit";  // reached the strain limit, but the stress had fallen by half: there was a peak
    EXPECT_EQ(kind(), "drop");
    recipe.drop = 0.051;
    EXPECT_EQ(kind(), "drop");
    recipe.drop = 0.049;
    EXPECT_EQ(kind(), "cap");
    recipe.drop = 0;
    EXPECT_EQ(kind(), "cap");
    recipe.stop_reason = "signal";  // neither a peak nor the cap
    EXPECT_EQ(kind(), "");
}

TEST(LoadCurve, UselessHistoriesAreRefused) {
    RunData run = data_of({});
    for (auto& column : run.history.columns) column.resize(2);
    EXPECT_THROW((void)load_curve(run), InputError);
    run = data_of({});
    for (double& stress : run.history[HistoryColumn::axial_stress]) stress = -stress;  // pulled in a compression test
    EXPECT_THROW((void)load_curve(run), InputError);
    run = data_of({});
    run.header.isotropic_end_time = 99;  // never left the isotropic stage
    EXPECT_THROW((void)load_curve(run), InputError);
}

}  // namespace
}  // namespace graincrack
