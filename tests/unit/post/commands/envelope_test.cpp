#include "post/commands/commands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

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

TEST(Envelope, RecoversPlantedCohesionAndFriction) {
    const std::vector<double> confining{0, 4e6, 8e6};
    std::vector<double> strength;
    for (double s : confining) strength.push_back(mohr_coulomb(21e6, 53 / degrees, s));
    const Envelope envelope = fit_envelope(confining, strength);
    EXPECT_NEAR(envelope.cohesion.value, 21e6, 1);
    EXPECT_NEAR(envelope.friction_angle.value * degrees, 53, 1e-7);
    EXPECT_NEAR(*envelope.cohesion.low, 21e6, 10);  // no scatter: no width
    EXPECT_NEAR(*envelope.friction_angle.high * degrees, 53, 1e-5);
}

TEST(Envelope, RecoversPlantedHoekBrown) {
    const std::vector<double> confining{0, 2e6, 4e6, 8e6, 20e6};
    std::vector<double> strength;
    for (double s : confining) strength.push_back(hoek_brown(122e6, 28, s));
    const auto fit = fit_hoek_brown(confining, strength);
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->sigma_ci.value, 122e6, 100);
    EXPECT_NEAR(fit->mi.value, 28, 1e-4);
    EXPECT_NEAR(*fit->mi.low, 28, 1e-3);
}

TEST(Envelope, HoekBrownWithTensionIsAnchoredAtTheTensileStrength) {
    const std::vector<double> confining{0, 4e6, 8e6};
    std::vector<double> strength;
    for (double s : confining) strength.push_back(hoek_brown(122e6, 14, s));
    const double planted = 122e6 / 2 * (std::sqrt(14.0 * 14 + 4) - 14);
    const auto exact = fit_hoek_brown(confining, strength, std::vector<double>{planted});
    ASSERT_TRUE(exact.has_value());
    EXPECT_NEAR(exact->mi.value, 14, 1e-3);
    EXPECT_NEAR(exact->tensile_strength(), planted, 10);
    EXPECT_NEAR(exact->strength(-planted), 0, 10);  // where σ1 = 0
    EXPECT_TRUE(std::isnan(exact->strength(-1.3 * planted)));
    // A smaller tensile strength draws mi up, so that the curve comes between.
    const auto drawn = fit_hoek_brown(confining, strength, std::vector<double>{0.8 * planted, 0.8 * planted});
    EXPECT_GT(drawn->mi.value, 14.5);
    EXPECT_LT(drawn->tensile_strength(), planted);
    EXPECT_GT(drawn->tensile_strength(), 0.8 * planted);
}

TEST(Envelope, CurvatureHasTheSignOfTheData) {
    const std::vector<double> confining{0, 4e6, 8e6};
    std::vector<double> concave;
    for (double s : confining) concave.push_back(hoek_brown(122e6, 28, s));
    const auto bent = fit_envelope(confining, concave).curvature;
    ASSERT_TRUE(bent.has_value());
    // Three points: c is the second difference over 2 h², h = 4 MPa
    EXPECT_NEAR(bent->value, (concave[2] - 2 * concave[1] + concave[0]) / (2 * 4e6 * 4e6), 1e-12);
    EXPECT_LT(bent->value, 0);
    EXPECT_FALSE(bent->low.has_value());
    EXPECT_FALSE(fit_envelope(std::vector<double>{0, 8e6}, std::vector<double>{1e8, 1.5e8}).curvature.has_value());
}

TEST(Envelope, LineImpliesATensileStrength) {
    const std::vector<double> confining{0, 4e6, 8e6};
    std::vector<double> strength;
    for (double s : confining) strength.push_back(mohr_coulomb(21e6, 53 / degrees, s));
    const double phi = 53 / degrees;
    EXPECT_NEAR(fit_envelope(confining, strength).tensile_strength(), 2 * 21e6 * std::cos(phi) / (1 + std::sin(phi)), 1);
}

TEST(Envelope, SeedsGiveTheirOwnConstants) {
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

TEST(Envelope, TwoTestsGiveValuesWithoutIntervals) {
    const std::vector<double> confining{0, 8e6};
    const std::vector<double> strength{hoek_brown(122e6, 28, 0), hoek_brown(122e6, 28, 8e6)};
    const Envelope envelope = fit_envelope(confining, strength);
    EXPECT_FALSE(envelope.cohesion.low.has_value());
    EXPECT_FALSE(envelope.friction_angle.high.has_value());
    ASSERT_TRUE(envelope.hoek_brown.has_value());
    EXPECT_FALSE(envelope.hoek_brown->mi.low.has_value());
    EXPECT_NEAR(envelope.hoek_brown->mi.value, 28, 1e-3);
}

TEST(Envelope, TestsThatDoNotDetermineTheLineGiveNoIntervals) {
    // A slope of 4 ± t(1) s with t(1) = 12.7: lines that fall are among those possible.
    const std::vector<double> confining{0, 4e6, 8e6};
    const std::vector<double> strength{100e6, 126e6, 132e6};
    const Envelope envelope = fit_envelope(confining, strength);
    EXPECT_NEAR(envelope.friction_angle.value * degrees, 36.87, 0.01);  // sin φ = 3/5
    EXPECT_FALSE(envelope.friction_angle.low.has_value());
    EXPECT_FALSE(envelope.friction_angle.high.has_value());
    EXPECT_FALSE(envelope.cohesion.low.has_value());
}

TEST(Envelope, CurvedUpwardsStillGivesARow) {  // run 5 of the paper's Table 7, far from any Hoek–Brown curve
    const std::vector<double> confining{0, 4e6, 8e6};
    const std::vector<double> strength{35.87e6, 183.62e6, 287.03e6};
    const Envelope envelope = fit_envelope(confining, strength);
    EXPECT_NEAR(envelope.cohesion.value * 1e-6, 3.9, 0.05);
    EXPECT_NEAR(envelope.friction_angle.value * degrees, 69.8, 0.05);
    if (envelope.hoek_brown) {
        EXPECT_GT(envelope.hoek_brown->sigma_ci.value, 0);
        EXPECT_TRUE(std::isfinite(envelope.hoek_brown->mi.value));
    }
}

class EnvelopeTable : public ::testing::Test {
protected:
    std::string run(const std::string& name, double confining, const std::string& test = "", double peak = 0, double drop = 0.5,
                    const std::string& stop = "peak drop") {
        Recipe recipe;
        recipe.drop = drop;
        recipe.stop_reason = stop;
        recipe.test = !test.empty() ? test : confining > 0 ? "triaxial" : "uniaxial";
        recipe.confining_pressure = confining;
        recipe.peak = peak > 0 ? peak : mohr_coulomb(21e6, 53 / degrees, confining);
        test::write_run(folder_.file(name), recipe);
        return folder_.file(name);
    }
    std::ostringstream notes_;
    test::TemporaryFolder folder_;
};

TEST_F(EnvelopeTable, RunsEndedByTheStrainCapAreRefusedUnlessAccepted) {
    const std::vector<std::string> runs{run("0", 0), run("4", 4e6, "", 0, 0.03, "strain limit"),
                                        run("8", 8e6, "", 0, 0, "strain limit")};
    std::ostringstream out;
    test::expect_one_line<InputError>(
        [&] {
            write_envelope_table(out, runs, TableFormat::tsv, {StrainLimitRuns::refuse, StrengthKind::largest}, notes_);
        },
        {runs[1], "strain limit (1.5 %)", "--capped accept"});
    EXPECT_EQ(out.str(), "");
    EXPECT_EQ(notes_.str(), "");
    write_envelope_table(out, runs, TableFormat::tsv, {StrainLimitRuns::accept, StrengthKind::largest}, notes_);
    EXPECT_EQ(field(out.str(), "runs_at_strain_limit"), "2");
    EXPECT_NEAR(std::stod(field(out.str(), "cohesion_MPa")), 21, 1e-4);
    EXPECT_NE(notes_.str().find("2 of 3 runs were stopped at the strain limit"), std::string::npos) << notes_.str();
    const std::string notes = notes_.str();
    EXPECT_EQ(std::count(notes.begin(), notes.end(), '\n'), 1);
}

TEST_F(EnvelopeTable, AStoppedRunHasNoStrengthAtAll) {
    std::ostringstream out;
    const std::vector<std::string> runs{run("0", 0), run("4", 4e6, "", 0, 0, "signal")};
    EXPECT_THROW(write_envelope_table(out, runs, TableFormat::tsv, {StrainLimitRuns::accept, StrengthKind::largest}, notes_),
                 InputError);
    EXPECT_EQ(out.str(), "");
}

TEST_F(EnvelopeTable, RowOfThreeRuns) {
    std::ostringstream out;
    write_envelope_table(out, {run("0", 0), run("4", 4e6), run("8", 8e6)}, TableFormat::tsv,
                         {StrainLimitRuns::refuse, StrengthKind::largest}, notes_);
    EXPECT_EQ(field(out.str(), "runs"), "3");
    EXPECT_EQ(field(out.str(), "runs_at_strain_limit"), "0");
    EXPECT_NEAR(std::stod(field(out.str(), "cohesion_MPa")), 21, 1e-4);
    EXPECT_NEAR(std::stod(field(out.str(), "friction_angle_deg")), 53, 1e-4);
    EXPECT_NE(field(out.str(), "hoek_brown_mi"), "");
}

TEST_F(EnvelopeTable, ForPeopleHasItsIntervalsAndUnits) {
    std::ostringstream out;
    write_envelope_table(out, {run("0", 0), run("4", 4e6), run("8", 8e6)}, TableFormat::aligned,
                         {StrainLimitRuns::refuse, StrengthKind::largest}, notes_);
    const std::string table = out.str();
    EXPECT_NE(table.find("3 of 3 compression runs, plane strain; strength: largest\n"), std::string::npos) << table;
    const std::size_t cohesion = table.find("cohesion C");
    ASSERT_NE(cohesion, std::string::npos) << table;
    const std::string line = table.substr(cohesion, table.find('\n', cohesion) - cohesion);
    EXPECT_NE(line.find(" 21 "), std::string::npos) << line;
    EXPECT_NE(line.find("21 to 21"), std::string::npos) << line;
    EXPECT_TRUE(line.ends_with("MPa")) << line;
    EXPECT_EQ(table.find('\t'), std::string::npos);
}

TEST_F(EnvelopeTable, ForPeopleSaysThatTooFewTestsGiveNoInterval) {
    std::ostringstream out;
    write_envelope_table(out, {run("0", 0), run("4", 4e6)}, TableFormat::aligned, {}, notes_);
    EXPECT_NE(out.str().find("not determined by 2 tests"), std::string::npos) << out.str();
}

TEST_F(EnvelopeTable, OtherStressesThanThePeakHaveTheirEnvelopes) {
    // Platen strain is 1.02e-4 at the end of the isotropic stage and grows by 1.02 (σ1 − σ3)/E' from there: the E' that
    // puts σ1 at 1 % strain on a planted line. No peak comes before 2 %, none of the runs reaches 3 %.
    std::vector<std::string> runs;
    for (const double confining : {4e6, 8e6, 12e6}) {
        Recipe recipe;
        recipe.test = "triaxial";
        recipe.confining_pressure = confining;
        const double wanted = mohr_coulomb(15e6, 40 / degrees, confining);
        recipe.plane_young_modulus = 1.02 * (wanted - confining) / (0.01 - 1.02e-4);
        recipe.peak = confining + 2.2 * (wanted - confining);
        recipe.rows = 2001;
        runs.push_back(folder_.file(std::to_string(confining)));
        test::write_run(runs.back(), recipe);
    }
    std::ostringstream out;
    write_envelope_table(out, runs, TableFormat::tsv, {StrainLimitRuns::refuse, StrengthKind::largest}, notes_);
    EXPECT_EQ(field(out.str(), "runs_at_1_percent"), "3");
    EXPECT_NEAR(std::stod(field(out.str(), "cohesion_at_1_percent_MPa")), 15, 1e-4);
    EXPECT_NEAR(std::stod(field(out.str(), "friction_angle_at_1_percent_deg")), 40, 1e-4);
    EXPECT_EQ(field(out.str(), "runs_at_2_percent"), "3");
    EXPECT_EQ(field(out.str(), "runs_at_3_percent"), "0");
    EXPECT_EQ(field(out.str(), "cohesion_at_3_percent_MPa"), "");
    EXPECT_EQ(field(out.str(), "runs_at_first_yield"), "0");  // straight to the peak
}

TEST_F(EnvelopeTable, OfFirstPeaksTakesEachRunThatHasOne) {
    // The last two never fall: one stopped at the strain limit, one by a signal.
    const std::vector<std::string> runs{run("0", 0), run("4", 4e6, "", 0, 0.1, "strain limit"),
                                        run("8", 8e6, "", 0, 0.5, "signal"), run("12", 12e6, "", 0, 0, "strain limit"),
                                        run("13", 12e6, "", 0, 0, "signal")};
    std::ostringstream out;
    write_envelope_table(out, runs, TableFormat::tsv, {.strength = StrengthKind::first_peak}, notes_);
    EXPECT_EQ(field(out.str(), "strength"), "first-peak");
    EXPECT_EQ(field(out.str(), "runs"), "3");
    EXPECT_EQ(field(out.str(), "compression_runs"), "5");
    EXPECT_EQ(field(out.str(), "runs_at_strain_limit"), "0");
    EXPECT_NEAR(std::stod(field(out.str(), "cohesion_MPa")), 21, 0.3);  // smoothing takes some of each peak
    EXPECT_LT(std::stod(field(out.str(), "cohesion_MPa")), 21 - 1e-3);
    EXPECT_NEAR(std::stod(field(out.str(), "friction_angle_deg")), 53, 0.3);
    const std::string notes = notes_.str();
    EXPECT_EQ(std::count(notes.begin(), notes.end(), '\n'), 2) << notes;
    EXPECT_NE(notes.find(runs[3] + ": no first peak"), std::string::npos) << notes;
}

TEST_F(EnvelopeTable, OfFirstPeaksIsTheUsualOne) {
    std::ostringstream out;
    const std::vector<std::string> runs{run("0", 0), run("4", 4e6), run("8", 8e6)};
    write_envelope_table(out, runs, TableFormat::tsv, {}, notes_);
    EXPECT_EQ(field(out.str(), "strength"), "first-peak");
    EXPECT_EQ(field(out.str(), "compression_runs"), "3");
    EXPECT_NEAR(std::stod(field(out.str(), "cohesion_MPa")), 21, 0.3);  // smoothing takes some of each peak
}

TEST_F(EnvelopeTable, OfResidualStrengthsNeedsTestsThatGoOnBehindTheirFirstPeak) {
    std::ostringstream out;
    std::vector<std::string> runs{run("0", 0), run("4", 4e6), run("8", 8e6)};  // end 0.1 % behind their peaks
    test::expect_one_line<InputError>(
        [&] { write_envelope_table(out, runs, TableFormat::tsv, {.strength = StrengthKind::residual}, notes_); },
        {runs[0], "before 0.5 % strain beyond its first peak", "0 of 3 compression runs have this strength"});
    EXPECT_EQ(out.str(), "");
    for (const double confining : {4e6, 8e6}) {  // a tenth as stiff
        Recipe recipe;
        recipe.test = "triaxial";
        recipe.confining_pressure = confining;
        recipe.plane_young_modulus = 2.6e9;
        recipe.peak = mohr_coulomb(21e6, 53 / degrees, confining);
        runs.push_back(folder_.file("soft" + std::to_string(confining)));
        test::write_run(runs.back(), recipe);
    }
    write_envelope_table(out, runs, TableFormat::tsv, {.strength = StrengthKind::residual}, notes_);
    EXPECT_EQ(field(out.str(), "strength"), "residual");
    EXPECT_EQ(field(out.str(), "runs"), "2");
    EXPECT_EQ(field(out.str(), "compression_runs"), "5");
    EXPECT_LT(std::stod(field(out.str(), "cohesion_MPa")), 20);
}

TEST_F(EnvelopeTable, TensileTestsStandBesideWhatTheEnvelopesImply) {
    std::ostringstream out;
    Recipe disc;
    disc.test = "brazilian";
    disc.plane = PlaneCondition::stress;  // stiffnesses follow the plane condition: the same rock
    disc.peak = 8.8e6;
    test::write_run(folder_.file("disc"), disc);
    const std::vector<std::string> runs{run("0", 0), run("4", 4e6), run("8", 8e6), folder_.file("disc"),
                                        run("t", 0, "tension", 6e6)};
    write_envelope_table(out, runs, TableFormat::tsv, {StrainLimitRuns::refuse, StrengthKind::largest}, notes_);
    EXPECT_EQ(field(out.str(), "runs"), "3");
    EXPECT_NEAR(std::stod(field(out.str(), "cohesion_MPa")), 21, 1e-4);
    EXPECT_EQ(field(out.str(), "brazilian_tensile_strength_MPa"), "8.8");
    EXPECT_EQ(field(out.str(), "direct_tensile_strength_MPa"), "6");
    EXPECT_EQ(field(out.str(), "tension_from"), "tension");
    EXPECT_NE(field(out.str(), "hoek_brown_with_tension_mi"), "");
    EXPECT_EQ(field(out.str(), "whole_seeds"), "0");
}

TEST_F(EnvelopeTable, OtherTestsAndOneConfiningPressureAreRefused) {
    std::ostringstream out;
    EXPECT_THROW(write_envelope_table(out, {run("0", 0), run("b", 0, "brazilian", 8e6)}, TableFormat::tsv,
                                      {StrainLimitRuns::refuse, StrengthKind::largest}, notes_),
                 InputError);
    EXPECT_THROW(write_envelope_table(out, {run("0", 0), run("1", 0)}, TableFormat::tsv,
                                      {StrainLimitRuns::refuse, StrengthKind::largest}, notes_),
                 InputError);
    EXPECT_EQ(out.str(), "");
}

TEST_F(EnvelopeTable, AnotherPlaneConditionIsRefused) {
    Recipe recipe;
    recipe.test = "triaxial";
    recipe.confining_pressure = 4e6;
    recipe.plane = PlaneCondition::stress;
    test::write_run(folder_.file("stress"), recipe);
    std::ostringstream out;
    try {
        write_envelope_table(out, {run("0", 0), folder_.file("stress")}, TableFormat::tsv,
                             {StrainLimitRuns::refuse, StrengthKind::largest}, notes_);
        FAIL() << "was accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("plane condition"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace graincrack
