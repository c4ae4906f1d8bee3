#include "post/fit/size_effect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "post/plot/plots.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

const std::vector<double> edges{2e-3, 3e-3, 5e-3, 7.5e-3};

RunData run_of(double edge, double strength, const std::string& test = "brazilian") {
    const test::Recipe recipe{.test = test, .plane = PlaneCondition::stress, .peak = strength};
    return {"run.h5", test::synthetic_header(recipe), test::synthetic_history(recipe), {0.08, 0.08, 1, 100, edge}};
}

std::string table_of(const std::vector<RunData>& runs, const EnvelopeOptions& options, std::ostream& notes) {
    return test::written(write_size_effect_table, runs, TableFormat::tsv, options, notes);
}

TEST(SizeEffect, FindsAnExactPowerLaw) {
    std::vector<double> strength;
    for (double edge : edges) strength.push_back(5e6 * std::pow(edge * 1e3, 0.39));
    const auto law = fit_power_law(edges, strength);
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(law->exponent.value, 0.39, 1e-9);
    EXPECT_NEAR(*law->exponent.high, 0.39, 1e-6);
    EXPECT_NEAR(law->coefficient, 5e6, 1);
    EXPECT_FALSE(fit_power_law({1e-3, 1e-3}, {1, 2}).has_value());
}

TEST(SizeEffect, WeighsASizeAsItsSeeds) {
    // Two sizes: the line goes through the means of the logarithms, however many runs each has.
    const auto law = fit_power_law({2e-3, 2e-3, 2e-3, 8e-3}, {1e6, 2e6, 4e6, 4e6});
    EXPECT_NEAR(law->exponent.value, std::log(2.0) / std::log(4.0), 1e-12);
    EXPECT_TRUE(law->exponent.low.has_value());
}

TEST(SizeEffect, HasASeriesForEachTestWithTheZone) {
    std::vector<RunData> runs;
    for (double edge : edges) {
        runs.push_back(run_of(edge, 5e6 * std::pow(edge * 1e3, 0.39)));
        runs.push_back(run_of(edge, 120e6, "uniaxial"));
    }
    std::ostringstream notes;
    const std::string table = table_of(runs, EnvelopeOptions{}, notes);
    EXPECT_EQ(notes.str(), "");
    EXPECT_EQ(test::parse_tsv(table).size(), 3U);
    EXPECT_EQ(test::field(table, "test"), "brazilian");
    EXPECT_EQ(test::field(table, "exponent"), "0.39");
    EXPECT_EQ(test::field(table, "coefficient"), "5");
    EXPECT_EQ(test::field(table, "paper_exponent"), "0.39");
    EXPECT_EQ(test::field(table, "theory_exponent"), "0.5");
    // (9π/32) E Gf/tc² over the edge, plane stress
    const double energy = test::synthetic_header({.plane = PlaneCondition::stress}).contact.fracture_energy;
    const double zone = 9 * std::numbers::pi / 32 * 25.8e9 * energy / (24.15e6 * 24.15e6);
    EXPECT_NEAR(test::number_in(table, "zone_over_smallest_edge"), zone / 2e-3, 1e-5);
    EXPECT_NEAR(test::number_in(table, "exponent", 1), 0, 1e-9);
    EXPECT_EQ(test::field(table, "paper_exponent", 1), "");
    test::expect_golden(draw_size_effect(collect_sizes(runs, EnvelopeOptions{})).words());
}

// Of a line through (-1, 0.01), (0, -0.02), (1, 0.01) the deviation is √6 % with one degree of freedom; in its middle the mean
// has a third of that variance, and Student's t is 12.706.
TEST(SizeEffect, HasABandOfTheIntervalOfTheFit) {
    const std::vector<double> sizes{1e-3 * std::exp(-1), 1e-3, 1e-3 * std::exp(1)};
    const auto law = fit_power_law(sizes, {std::exp(0.01), std::exp(-0.02), std::exp(0.01)});
    ASSERT_TRUE(law);
    const Estimate middle = law->strength_at(1e-3);
    EXPECT_NEAR(std::log(middle.value), 0, 1e-12);
    EXPECT_NEAR(std::log(*middle.high), 12.706 * 0.01 * std::sqrt(2), 1e-5);
    EXPECT_NEAR(std::log(*middle.low), -std::log(*middle.high), 1e-9);
    EXPECT_NEAR(std::log(*law->strength_at(sizes[2]).high), 12.706 * 0.01 * std::sqrt(5), 1e-5);
}

TEST(SizeEffect, IsNotComparedWithThePapersForAnotherRock) {
    std::vector<RunData> runs;
    for (const double edge : edges) runs.push_back(run_of(edge, 5e6 * std::pow(edge * 1e3, 0.3)));
    for (RunData& run : runs) run.header.material = "Carrara marble";
    std::ostringstream notes;
    const std::string table = table_of(runs, EnvelopeOptions{}, notes);
    EXPECT_EQ(test::field(table, "exponent"), "0.3");
    EXPECT_EQ(test::field(table, "paper_exponent"), "");
    test::expect_golden(draw_size_effect(collect_sizes(runs, EnvelopeOptions{})).words());
}

TEST(SizeEffect, NeedsTwoSizesOfRunsThatFailed) {
    std::ostringstream notes;
    test::GoldenRefusals refused;
    const auto add = [&](const std::string& what, const std::vector<RunData>& runs, StrengthKind kind) {
        refused.add<InputError>(what, [&] { table_of(runs, EnvelopeOptions{.strength = kind}, notes); });
    };
    // Seeds of one size differ by half a percent in their mean edge: no line goes through them.
    add("one size", {run_of(1.99e-3, 8e6), run_of(2e-3, 9e6)}, StrengthKind::first_peak);
    std::vector<RunData> at_strain_limit{run_of(2e-3, 8e6), run_of(4e-3, 9e6)};
    at_strain_limit[1].header.stop_reason = "strain limit";
    at_strain_limit[1].history = test::synthetic_history({.test = "brazilian", .drop = 0});
    add("one test that did not fail", at_strain_limit, StrengthKind::largest);
    add("one size without the test that did not fail", at_strain_limit, StrengthKind::first_peak);
    std::vector<RunData> three = at_strain_limit;
    three.push_back(run_of(4e-3, 16e6));
    EXPECT_EQ(test::field(table_of(three, EnvelopeOptions{}, notes), "exponent"), "1");
    EXPECT_EQ(test::field(table_of(at_strain_limit, EnvelopeOptions{StrainLimitRuns::accept, StrengthKind::largest}, notes),
                          "runs_at_strain_limit"),
              "1");
    test::expect_golden(notes.str(), "notes");
}

}  // namespace
}  // namespace graincrack
