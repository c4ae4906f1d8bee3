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

const std::vector<double> three_pressures{0, 4e6, 8e6};
std::vector<double> hoek_brown_strengths(double mi) {
    std::vector<double> strengths;
    for (const double s : three_pressures) strengths.push_back(hoek_brown(122e6, mi, s));
    return strengths;
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

TEST(Envelope, HoekBrownFindsWhatWasPlanted) {
    const double planted = 122e6 / 2 * (std::sqrt(14.0 * 14 + 4) - 14);
    const auto exact = fit_hoek_brown(three_pressures, hoek_brown_strengths(14));
    ASSERT_TRUE(exact.has_value());
    EXPECT_NEAR(exact->sigma_ci.value, 122e6, 1e3);
    EXPECT_NEAR(exact->mi.value, 14, 1e-3);
    EXPECT_NEAR(exact->tensile_strength(), planted, 10);
    EXPECT_NEAR(exact->strength(-planted), 0, 10);  // where σ1 = 0
    EXPECT_TRUE(std::isnan(exact->strength(-1.3 * planted)));
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

TEST(Envelope, WhatIsNotDeterminedHasNoInterval) {
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

class EnvelopeTable : public ::testing::Test {
protected:
    std::string run(const std::string& name, double confining, const std::string& test = "", double peak = 0, double drop = 0.5,
                    const std::string& stop = "peak drop", Recipe recipe = {}) {
        recipe.drop = drop;
        recipe.stop_reason = stop;
        recipe.test = !test.empty() ? test : confining > 0 ? "triaxial" : "uniaxial";
        recipe.confining_pressure = confining;
        recipe.peak = peak > 0 ? peak : mohr_coulomb(21e6, 53 / degrees, confining);
        test::write_run(folder_.file(name), recipe);
        return folder_.file(name);
    }
    std::vector<std::string> three_runs() { return {run("0", 0), run("4", 4e6), run("8", 8e6)}; }
    std::string table(const std::vector<std::string>& runs, const EnvelopeOptions& options,
                      TableFormat format = TableFormat::tsv) {
        std::ostringstream out;
        write_envelope_table(out, runs, format, options, notes_);
        return out.str();
    }
    const EnvelopeOptions of_largest_{StrainLimitRuns::refuse, StrengthKind::largest};
    std::ostringstream notes_;
    test::TemporaryFolder folder_;
};

TEST_F(EnvelopeTable, RunsEndedByTheStrainCapAreRefusedUnlessAccepted) {
    const std::vector<std::string> runs{run("0", 0), run("4", 4e6, "", 0, 0.03, "strain limit"),
                                        run("8", 8e6, "", 0, 0, "strain limit")};
    test::expect_one_line<InputError>([&] { table(runs, of_largest_); }, {runs[1], "strain limit (1.5 %)", "--capped accept"});
    EXPECT_EQ(notes_.str(), "");
    const std::string accepted = table(runs, {StrainLimitRuns::accept, StrengthKind::largest});
    EXPECT_EQ(field(accepted, "runs_at_strain_limit"), "2");
    EXPECT_NEAR(std::stod(field(accepted, "cohesion_MPa")), 21, 1e-4);
    const std::string notes = notes_.str();
    EXPECT_NE(notes.find("2 of 3 runs were stopped at the strain limit"), std::string::npos) << notes;
    EXPECT_EQ(std::count(notes.begin(), notes.end(), '\n'), 1);
    // A run that a signal stopped has no strength at all.
    EXPECT_THROW(table({run("0", 0), run("4", 4e6, "", 0, 0, "signal")}, {StrainLimitRuns::accept, StrengthKind::largest}),
                 InputError);
}

TEST_F(EnvelopeTable, ForPeopleHasItsIntervalsAndUnits) {
    const std::string text = table(three_runs(), of_largest_, TableFormat::aligned);
    EXPECT_NE(text.find("3 of 3 compression runs, plane strain; strength: largest stress\n"), std::string::npos) << text;
    const std::size_t cohesion = text.find("cohesion C");
    ASSERT_NE(cohesion, std::string::npos) << text;
    const std::string line = text.substr(cohesion, text.find('\n', cohesion) - cohesion);
    EXPECT_NE(line.find(" 21 "), std::string::npos) << line;
    EXPECT_NE(line.find("21 to 21"), std::string::npos) << line;
    EXPECT_TRUE(line.ends_with("MPa")) << line;
    EXPECT_EQ(text.find('\t'), std::string::npos);
    const std::string few = table({run("0", 0), run("4", 4e6)}, {}, TableFormat::aligned);
    EXPECT_NE(few.find("not determined by 2 tests"), std::string::npos) << few;
    const std::string columns = table({run("0", 0), run("4", 4e6)}, {});
    EXPECT_EQ(field(columns, "cohesion_MPa") + field(columns, "friction_angle_deg") + field(columns, "hoek_brown_mi"), "");
}

TEST_F(EnvelopeTable, OfFirstPeaksIsTheUsualOneAndTakesEachRunThatHasOne) {
    // The last two never fall: one stopped at the strain limit, one by a signal.
    const std::vector<std::string> runs{run("0", 0), run("4", 4e6, "", 0, 0.1, "strain limit"),
                                        run("8", 8e6, "", 0, 0.5, "signal"), run("12", 12e6, "", 0, 0, "strain limit"),
                                        run("13", 13e6, "", 0, 0, "signal")};
    const std::string usual = table(runs, {});
    EXPECT_EQ(field(usual, "strength"), "first-peak");
    EXPECT_EQ(field(usual, "runs"), "3");
    EXPECT_EQ(field(usual, "compression_runs"), "5");
    EXPECT_EQ(field(usual, "runs_at_strain_limit"), "0");
    EXPECT_NEAR(std::stod(field(usual, "cohesion_MPa")), 21, 0.3);  // smoothing takes some of each peak
    EXPECT_LT(std::stod(field(usual, "cohesion_MPa")), 21 - 1e-3);
    EXPECT_NEAR(std::stod(field(usual, "friction_angle_deg")), 53, 0.3);
    const std::string notes = notes_.str();
    EXPECT_EQ(std::count(notes.begin(), notes.end(), '\n'), 2) << notes;
    EXPECT_NE(notes.find(runs[3] + ": did not fail"), std::string::npos) << notes;
}

TEST_F(EnvelopeTable, OfResidualStrengthsNeedsTestsThatGoOnBehindTheirFirstPeak) {
    std::vector<std::string> runs = three_runs();  // end 0.1 % behind their peaks
    test::expect_one_line<InputError>(
        [&] { table(runs, {.strength = StrengthKind::residual}); },
        {runs[0], "before 0.5 % strain beyond its first peak", "0 of 3 compression runs have this strength"});
    for (const double confining : {4e6, 8e6, 12e6}) {  // a tenth as stiff
        Recipe recipe;
        recipe.test = "triaxial";
        recipe.confining_pressure = confining;
        recipe.plane_young_modulus = 2.6e9;
        recipe.peak = mohr_coulomb(21e6, 53 / degrees, confining);
        runs.push_back(folder_.file("soft" + std::to_string(confining)));
        test::write_run(runs.back(), recipe);
    }
    const std::string residual = table(runs, {.strength = StrengthKind::residual});
    EXPECT_EQ(field(residual, "strength"), "residual");
    EXPECT_EQ(field(residual, "runs"), "3");
    EXPECT_EQ(field(residual, "compression_runs"), "6");
    EXPECT_LT(std::stod(field(residual, "cohesion_MPa")), 20);
}

TEST_F(EnvelopeTable, TensileTestsStandBesideWhatTheEnvelopesImply) {
    Recipe disc;
    disc.test = "brazilian";
    disc.plane = PlaneCondition::stress;  // stiffnesses follow the plane condition: the same rock
    disc.peak = 8.8e6;
    test::write_run(folder_.file("disc"), disc);
    std::vector<std::string> runs = three_runs();
    runs.insert(runs.end(), {folder_.file("disc"), run("t", 0, "tension", 6e6)});
    const std::string row = table(runs, of_largest_);
    EXPECT_EQ(field(row, "runs"), "3");
    EXPECT_EQ(field(row, "runs_at_strain_limit"), "0");
    EXPECT_NEAR(std::stod(field(row, "cohesion_MPa")), 21, 1e-4);
    EXPECT_NEAR(std::stod(field(row, "friction_angle_deg")), 53, 1e-4);
    EXPECT_NE(field(row, "hoek_brown_mi"), "");
    EXPECT_EQ(field(row, "brazilian_tensile_strength_MPa"), "8.8");
    EXPECT_EQ(field(row, "direct_tensile_strength_MPa"), "6");
    EXPECT_EQ(field(row, "whole_seeds"), "0");
}

TEST_F(EnvelopeTable, OtherTestsOnePressureAndAnotherPlaneConditionAreRefused) {
    EXPECT_THROW(table({run("0", 0), run("b", 0, "brazilian", 8e6)}, of_largest_), InputError);
    EXPECT_THROW(table({run("0", 0), run("1", 0)}, of_largest_), InputError);
    Recipe recipe;
    recipe.test = "triaxial";
    recipe.confining_pressure = 4e6;
    recipe.plane = PlaneCondition::stress;
    test::write_run(folder_.file("stress"), recipe);
    test::expect_one_line<InputError>(
        [&] {
            table({run("0", 0), folder_.file("stress")}, of_largest_);
        },
        {"plane (stress, strain)"});
    recipe.plane = PlaneCondition::strain;
    recipe.specimen = test::grid_specimen(4, 8, 0.04, 0.08);
    test::write_run(folder_.file("small"), recipe);
    test::expect_one_line<InputError>(
        [&] {
            table({run("0", 0), folder_.file("small")}, of_largest_);
        },
        {"width (40 mm, 80 mm), height (80 mm, 160 mm)"});
}

}  // namespace
}  // namespace graincrack
