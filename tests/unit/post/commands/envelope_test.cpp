#include "post/commands/commands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using test::field;
using test::Recipe;

constexpr double degrees = 180 / std::numbers::pi;

double mohr_coulomb(double cohesion, double friction_angle, double confining) {
    const double b = (1 + std::sin(friction_angle)) / (1 - std::sin(friction_angle));
    return 2 * cohesion * std::sqrt(b) + b * confining;
}
double hoek_brown(double sigma_ci, double mi, double confining) {
    return confining + sigma_ci * std::sqrt(mi * confining / sigma_ci + 1);
}

const std::vector<double> three_pressures{0, 4e6, 8e6};

/// The fields of a row, with spaces between.
std::string fields(const std::string& row, const std::vector<std::string>& columns) {
    std::string all;
    for (const std::string& column : columns) all += (all.empty() ? "" : " ") + field(row, column);
    return all;
}

TEST(Envelope, RecoversPlantedCohesionAndFriction) {
    std::vector<double> strength;
    for (const double s : three_pressures) strength.push_back(mohr_coulomb(21e6, 53 / degrees, s));
    const Envelope envelope = fit_envelope(three_pressures, strength);
    EXPECT_NEAR(envelope.cohesion.value, 21e6, 1);
    EXPECT_NEAR(envelope.friction_angle.value * degrees, 53, 1e-7);
    EXPECT_NEAR(*envelope.cohesion.low, 21e6, 10);  // no scatter: no width
    EXPECT_NEAR(*envelope.friction_angle.high * degrees, 53, 1e-5);
    const double phi = 53 / degrees;
    EXPECT_NEAR(envelope.tensile_strength(), 2 * 21e6 * std::cos(phi) / (1 + std::sin(phi)), 1);
}

TEST(HoekBrown, RecoversWhatWasPlanted) {
    const double planted = 122e6 / 2 * (std::sqrt(14.0 * 14 + 4) - 14);
    std::vector<double> strengths;
    for (const double s : three_pressures) strengths.push_back(hoek_brown(122e6, 14, s));
    const auto exact = fit_hoek_brown(three_pressures, strengths);
    ASSERT_TRUE(exact.has_value());
    EXPECT_NEAR(exact->sigma_ci.value, 122e6, 1e3);
    EXPECT_NEAR(exact->mi.value, 14, 1e-3);
    EXPECT_NEAR(exact->tensile_strength(), planted, 10);
    EXPECT_NEAR(exact->strength(-planted), 0, 10);  // where σ1 = 0
    EXPECT_TRUE(std::isnan(exact->strength(-1.3 * planted)));
}

TEST(Envelope, HasConstantsOfEachSeed) {
    EnvelopeTests tests;
    const std::vector<double> cohesions{20e6, 21e6, 25e6};
    for (std::size_t i = 0; i < cohesions.size(); ++i) {
        for (double s : {0.0, 4e6, 8e6}) {
            tests.compression.push_back({s, mohr_coulomb(cohesions[i], 50 / degrees, s), static_cast<std::int64_t>(i + 1)});
        }
    }
    tests.compression.push_back({0, 100e6, 9});  // a seed with one pressure only is left out
    const auto seeds = fit_seed_envelopes(tests);
    ASSERT_TRUE(seeds.has_value());
    EXPECT_EQ(seeds->seeds, 3U);
    EXPECT_NEAR(seeds->cohesion.mean.value, 22e6, 10);
    EXPECT_NEAR(*seeds->cohesion.deviation, std::sqrt(7.0) * 1e6, 10);
    EXPECT_NEAR(seeds->friction_angle.mean.value * degrees, 50, 1e-6);
    tests.compression.resize(3);
    EXPECT_FALSE(fit_seed_envelopes(tests).has_value());
}

TEST(Envelope, HasNoIntervalOfWhatIsNotDetermined) {
    const auto expect_no_interval = [](const Envelope& envelope) {
        EXPECT_FALSE(envelope.cohesion.low.has_value());
        EXPECT_FALSE(envelope.friction_angle.low.has_value());
        EXPECT_FALSE(envelope.friction_angle.high.has_value());
    };
    const Envelope two = fit_envelope(std::vector<double>{0, 8e6}, std::vector<double>{122e6, hoek_brown(122e6, 28, 8e6)});
    expect_no_interval(two);
    ASSERT_TRUE(two.hoek_brown.has_value());
    EXPECT_FALSE(two.hoek_brown->mi.low.has_value());
    EXPECT_NEAR(two.hoek_brown->mi.value, 28, 1e-3);
    // A slope of 4 ± t(1) s with t(1) = 12.7: lines that fall are among those possible.
    const Envelope three = fit_envelope(three_pressures, std::vector<double>{100e6, 126e6, 132e6});
    expect_no_interval(three);
    EXPECT_NEAR(three.friction_angle.value * degrees, 36.87, 0.01);  // sin φ = 3/5
    // Run 5 of the paper's Table 7, which is curved upwards, far from any Hoek–Brown curve.
    const Envelope upwards = fit_envelope(three_pressures, std::vector<double>{35.87e6, 183.62e6, 287.03e6});
    EXPECT_NEAR(upwards.cohesion.value * 1e-6, 3.9, 0.05);
    EXPECT_NEAR(upwards.friction_angle.value * degrees, 69.8, 0.05);
}

class EnvelopeTable : public test::RunFolder {
protected:
    /// Of a compression test of the planted cohesion and friction.
    static Recipe planted(double confining, double drop = 0.5, const std::string& stop = "peak drop") {
        return {.test = confining > 0 ? "triaxial" : "uniaxial",
                .confining_pressure = confining,
                .peak = mohr_coulomb(21e6, 53 / degrees, confining),
                .drop = drop,
                .stop_reason = stop};
    }
    std::vector<std::string> three_runs() { return {run("0", planted(0)), run("4", planted(4e6)), run("8", planted(8e6))}; }
    std::string table(const std::vector<std::string>& runs, const EnvelopeOptions& options,
                      TableFormat format = TableFormat::tsv) {
        return test::written(write_envelope_table, runs, format, options, notes_);
    }
    void refuse(const std::string& what, const std::vector<std::string>& runs, const EnvelopeOptions& options) {
        refused_.add<InputError>(what, [&] { table(runs, options); });
    }
    const EnvelopeOptions of_largest_{StrainLimitRuns::refuse, StrengthKind::largest};
    const EnvelopeOptions accepted_{StrainLimitRuns::accept, StrengthKind::largest};
    std::ostringstream notes_;
    test::GoldenRefusals refused_;
};

TEST_F(EnvelopeTable, HasRunsEndedByTheStrainCapIfTheyAreAccepted) {
    const std::vector<std::string> runs{run("0", planted(0)), run("4", planted(4e6, 0.03, "strain limit")),
                                        run("8", planted(8e6, 0, "strain limit"))};
    refuse("at the strain limit", runs, of_largest_);
    EXPECT_EQ(notes_.str(), "");
    const std::string accepted = table(runs, accepted_);
    EXPECT_EQ(field(accepted, "runs_at_strain_limit"), "2");
    EXPECT_NEAR(std::stod(field(accepted, "cohesion_MPa")), 21, 1e-4);
    test::expect_golden(notes_.str(), "notes");
    refuse("stopped by a signal", {runs[0], run("4", planted(4e6, 0, "signal"))}, accepted_);
}

TEST_F(EnvelopeTable, HasIntervalsAndUnitsForPeople) {
    test::expect_golden(table(three_runs(), of_largest_, TableFormat::aligned));
    const std::vector<std::string> two{run("0", planted(0)), run("4", planted(4e6))};
    test::expect_golden(table(two, {}, TableFormat::aligned), "of two tests");
    const std::string columns = table(two, {});
    EXPECT_EQ(field(columns, "cohesion_MPa") + field(columns, "friction_angle_deg") + field(columns, "hoek_brown_mi"), "");
}

TEST_F(EnvelopeTable, IsUsuallyThatOfFirstPeaksOfEachRunThatHasOne) {
    // The last two never fall: one stopped at the strain limit, one by a signal.
    const std::vector<std::string> runs{run("0", planted(0)), run("4", planted(4e6, 0.1, "strain limit")),
                                        run("8", planted(8e6, 0.5, "signal")), run("12", planted(12e6, 0, "strain limit")),
                                        run("13", planted(13e6, 0, "signal"))};
    const std::string usual = table(runs, {});
    EXPECT_EQ(fields(usual, {"strength", "runs", "compression_runs", "runs_at_strain_limit"}), "first-peak 3 5 0");
    EXPECT_NEAR(std::stod(field(usual, "cohesion_MPa")), 21, 0.3);  // smoothing takes some of each peak
    EXPECT_LT(std::stod(field(usual, "cohesion_MPa")), 21 - 1e-3);
    EXPECT_NEAR(std::stod(field(usual, "friction_angle_deg")), 53, 0.3);
    test::expect_golden(notes_.str());
}

TEST_F(EnvelopeTable, OfResidualStrengthsNeedsTestsThatGoOnBehindTheirFirstPeak) {
    std::vector<std::string> runs = three_runs();  // end 0.1 % behind their peaks
    refuse("ended early", runs, {.strength = StrengthKind::residual});
    for (const double confining : {4e6, 8e6, 12e6}) {
        Recipe soft = planted(confining);
        soft.plane_young_modulus = 2.6e9;  // a tenth as stiff
        runs.push_back(run("soft" + std::to_string(confining), soft));
    }
    const std::string residual = table(runs, {.strength = StrengthKind::residual});
    EXPECT_EQ(fields(residual, {"strength", "runs", "compression_runs"}), "residual 3 6");
    EXPECT_LT(std::stod(field(residual, "cohesion_MPa")), 20);
}

TEST_F(EnvelopeTable, HasTensileTestsBesideWhatTheEnvelopesImply) {
    std::vector<std::string> runs = three_runs();
    // Stiffnesses follow the plane condition: the same rock.
    runs.push_back(run("disc", {.test = "brazilian", .plane = PlaneCondition::stress, .peak = 8.8e6}));
    runs.push_back(run("t", {.test = "tension", .peak = 6e6}));
    const std::string row = table(runs, of_largest_);
    EXPECT_EQ(fields(row, {"runs", "brazilian_tensile_strength_MPa", "direct_tensile_strength_MPa", "whole_seeds"}), "3 8.8 6 0");
    EXPECT_NEAR(std::stod(field(row, "cohesion_MPa")), 21, 1e-4);
    EXPECT_NEAR(std::stod(field(row, "friction_angle_deg")), 53, 1e-4);
    EXPECT_NE(field(row, "hoek_brown_mi"), "");
}

TEST_F(EnvelopeTable, NeedsTwoPressuresInOnePlaneConditionAndSize) {
    const std::string first = run("0", planted(0));
    refuse("no compression", {first, run("b", {.test = "brazilian", .peak = 8e6})}, of_largest_);
    refuse("one pressure", {first, run("1", planted(0))}, of_largest_);
    Recipe other = planted(4e6);
    other.plane = PlaneCondition::stress;
    refuse("plane stress", {first, run("stress", other)}, of_largest_);
    other = planted(4e6);
    other.specimen = test::grid_specimen(4, 8, 0.04, 0.08);
    refuse("a smaller specimen", {first, run("small", other)}, of_largest_);
}

}  // namespace
}  // namespace graincrack
