// What stands beside a strength is of its row: a test that hardens behind its first peak has what the same test has that its
// fall ended.
#include <gtest/gtest.h>

#include "post/cracks/crack_counts.hpp"
#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/strength_table.hpp"
#include "post/measure/thresholds.hpp"
#include "post/run/run_state.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using test::field;

/// The peak of 125 MPa is at 1 s and 0.49 % of strain; the stress falls to 80 MPa by 1.25 s, and rises to 160 MPa.
class Hardening : public test::RunFolder {
protected:
    Hardening() {
        run("ended.h5", {.drop = 0.36});
        run("hardens.h5", {.drop = 0.36, .hardens_to = 160e6, .stop_reason = "strain limit"});
    }
    std::string strength_of(const std::string& file, TableFormat format = TableFormat::tsv,
                            StrengthKind kind = StrengthKind::first_peak) {
        return test::written([&](std::ostream& out) { write_strength_table(out, {file}, format, notes_, kind); });
    }
    std::string moduli_of(const std::string& file) {
        return test::written([&](std::ostream& out) { write_moduli_table(out, {file}, TableFormat::tsv, notes_); });
    }
    std::string ended_ = path("ended.h5"), hardens_ = path("hardens.h5");
    std::ostringstream notes_;
};

TEST_F(Hardening, HasTheLargestStressInARowOfItsOwn) {
    const RunData run = read_run_data(hardens_);
    const LoadCurve curve = load_curve(run);
    EXPECT_EQ(curve.peak, load_curve(read_run_data(ended_)).peak);
    EXPECT_EQ(run.history[HistoryColumn::time][curve.peak], 1);
    EXPECT_EQ(curve.largest, curve.stress.size() - 1);
    EXPECT_TRUE(curve.exceeds_strength());
    EXPECT_NEAR(curve.strength->stress, 124.6e6, 0.1e6);  // smoothed
    const Strength strength = measure_strength(run, curve);
    EXPECT_EQ(strength.reported(), curve.strength->stress);
    EXPECT_NEAR(strength.reported(StrengthKind::largest).value(), 160e6, 1);
    EXPECT_TRUE(strength.has_peak());
    EXPECT_FALSE(strength.has_peak(StrengthKind::largest));
}

TEST_F(Hardening, HasTheRowOfTheStrengthInTheTable) {
    const std::string ended = strength_of(ended_), hardens = strength_of(hardens_);
    for (const char* column :
         {"strain_at_peak", "peak_kind", "first_yield_MPa", "tensile_cracks", "shear_cracks", "tensile_cracks_by_sign",
          "shear_cracks_by_sign", "tensile_cracks_broken", "first_peak_MPa", "peak_load_kN/m"}) {
        EXPECT_EQ(field(hardens, column), field(ended, column)) << column;
    }
    EXPECT_EQ(field(ended, "peak_compressive_stress_MPa") + field(hardens, "peak_compressive_stress_MPa"), "125160");
    test::expect_golden(test::narrow(strength_of(hardens_, TableFormat::aligned, StrengthKind::first_peak)), "first peak");
    test::expect_golden(test::narrow(strength_of(hardens_, TableFormat::aligned, StrengthKind::largest)), "largest");
}

TEST_F(Hardening, HasModuliAndThresholdsAsFractionsOfTheStrength) {
    const std::string ended = moduli_of(ended_), hardens = moduli_of(hardens_);
    EXPECT_EQ(hardens.substr(hardens.find("hardens.h5") + 10), ended.substr(ended.find("ended.h5") + 8));
    EXPECT_EQ(field(hardens, "warning"), "");
    EXPECT_NE(field(hardens, "post_peak_slope_over_young_modulus"), "");
}

TEST_F(Hardening, HasFramesAndCountsOfTheTimeOfThePeak) {
    const RunReader run(hardens_);
    for (const char* word : {"before", "peak", "after"}) {
        EXPECT_EQ(choose_frame(run, word, {}), choose_frame(RunReader(ended_), word, {})) << word;
    }
    EXPECT_EQ(choose_frame(run, "peak", {}), 1U);
    const RunClasses hardens = read_classes(run, {}), ended = read_classes(RunReader(ended_), {});
    EXPECT_EQ(hardens.classes.at(0).at_peak->tensile, ended.classes.at(0).at_peak->tensile);
    EXPECT_LT(hardens.classes.at(0).at_peak->tensile, hardens.classes.at(0).at_end.tensile);
}

// No point of the log is broken, so that by broken contacts nothing has failed.
TEST_F(Hardening, HasTheSameStrengthForEveryCrackLabel) {
    const RunData run = run_data(RunReader(hardens_), {CrackEvent::broken});
    EXPECT_EQ(run.history[HistoryColumn::tensile_cracks].back(), 0);
    EXPECT_EQ(load_curve(run).peak, load_curve(read_run_data(hardens_)).peak);
}

}  // namespace
}  // namespace graincrack
