#include "post/measure/strength_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "post/cracks/crack_counts.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/run/comparability.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using test::field;
using test::number_in;
using test::Recipe;

class StrengthTable : public test::RunFolder {
protected:
    std::string table_of(const std::vector<std::string>& files, TableFormat format, StrengthKind kind = StrengthKind::first_peak,
                         ColumnChoice columns = ColumnChoice::all, const std::vector<std::string>& options = {}) {
        return test::written(write_strength_table, files, format, notes_, kind, columns, options);
    }
    std::string table_of(const Recipe& recipe, StrengthKind kind = StrengthKind::first_peak) {
        return table_of({run("run.h5", recipe)}, TableFormat::tsv, kind);
    }
    /// The cells of the row that are not empty, a line each, without the file.
    static std::string row_of(const std::string& table) {
        std::string text;
        const auto rows = test::parse_tsv(table);
        for (std::size_t i = 1; i < rows.at(0).size(); ++i) {
            if (!rows.at(1).at(i).empty()) text += rows[0][i] + ": " + rows[1][i] + "\n";
        }
        return text;
    }
    std::ostringstream notes_;
};

TEST_F(StrengthTable, HasTheColumnsScriptsRelyOnAndRowsOfTests) {
    const std::string uniaxial = table_of({});
    test::expect_golden(row_of(uniaxial), "uniaxial");
    EXPECT_NEAR(number_in(uniaxial, "strain_at_peak"), 1.02 * 125e6 / 26e9, 1e-9);
    EXPECT_NEAR(number_in(uniaxial, "ns_per_grain_step"), 12.8e9 / (200000.0 * 256), 1e-4);
    const ModeCounts at_peak = count_modes(test::synthetic_cracks(test::Recipe{}.specimen), {}, 1);  // s
    EXPECT_EQ(field(uniaxial, "tensile_cracks"), count_cell(at_peak.tensile).text());
    EXPECT_EQ(field(uniaxial, "shear_cracks"), count_cell(at_peak.shear).text());
    EXPECT_GT(at_peak.tensile * at_peak.shear, 0);
    const std::string usual = table_of({folder_.file("run.h5")}, TableFormat::tsv, {}, ColumnChoice::usual);
    test::expect_golden(usual.substr(0, usual.find('\n')), "columns");
    // Without the checks of an end; without a first peak.
    test::expect_golden(row_of(table_of({.stop_reason = "checkpoint"})), "checkpoint");
    test::expect_golden(row_of(table_of({.test = "tension", .peak = 6e6})), "tension");
}

// 2 kN/m on rollers at 80 mm: 3 F S/(2 H²) = 0.6 MPa for H = 20 mm. A notch makes it a nominal stress, no strength.
TEST_F(StrengthTable, HasTheLoadOfBendingAndTheFlexuralStrengthOfABeam) {
    // The peak is load over length.
    Recipe recipe{.test = "bend", .peak = 2e3 / 0.09, .specimen = test::grid_specimen(18, 4, 0.09, 0.02), .span = 0.08};
    recipe.specimen.shape = "beam";
    const std::string beam = table_of(recipe);
    EXPECT_NEAR(number_in(beam, "peak_load_kN/m"), 2, 1e-4);
    EXPECT_NEAR(number_in(beam, "flexural_strength_MPa"), 0.6, 1e-5);
    EXPECT_EQ(field(beam, "span_mm"), "80");
    EXPECT_EQ(field(beam, "tensile_strength_MPa") + field(beam, "peak_compressive_stress_MPa"), "");
    recipe.specimen.contact_kind[0] = 1;
    EXPECT_EQ(field(table_of(recipe), "flexural_strength_MPa"), "");
    EXPECT_EQ(field(table_of({}), "span_mm"), "");
}

TEST_F(StrengthTable, InterpolatesStressesAtEqualStrainsUpToTheEnd) {
    // Peak of 125 MPa at 1.25 %, end at 1.5 % and 62.5 MPa.
    const std::string table = table_of({.plane_young_modulus = 10e9, .platen_compliance = 1});
    EXPECT_NEAR(number_in(table, "stress_at_1_percent_MPa"), 100, 1e-5);
    EXPECT_EQ(field(table, "stress_at_2_percent_MPa"), "");
    // Peak at 2.5 %, end at 3 % and 62.5 MPa; 0.5 % below it the fall is linear.
    const std::string softer = table_of({.plane_young_modulus = 5e9, .platen_compliance = 1});
    EXPECT_NEAR(number_in(softer, "stress_at_2_percent_MPa"), 100, 1e-5);
    EXPECT_NEAR(number_in(softer, "stress_at_3_percent_MPa"), 62.5, 1e-5);
}

TEST_F(StrengthTable, IncludesTheConfinementInFirstPeakAndResidualStrength) {
    // Peak of 125 MPa at 4 % of the gauges, then a fall by 6.25 MPa every 2 % of that strain.
    const std::string table = table_of(
        {.test = "triaxial", .plane_young_modulus = 3e9, .platen_compliance = 1, .confining_pressure = 5e6, .rows = 1001});
    const double first_peak = number_in(table, "first_peak_MPa");
    EXPECT_NEAR(first_peak, 125, 0.2);
    EXPECT_EQ(field(table, "peak_compressive_stress_MPa"), "125");
    const double slope = 6.25 / (0.02 * (120e6 / 3e9 + 1e-4));  // MPa
    EXPECT_NEAR(number_in(table, "residual_MPa"), 125 - 0.004 * slope, 0.5);
    EXPECT_NEAR(number_in(table, "drop_percent"), 100 * (first_peak - number_in(table, "residual_MPa")) / (first_peak - 5), 1e-3);
    EXPECT_NEAR(number_in(table, "rehardening_GPa"), -1e-3 * slope, 1e-3 * slope * 0.01);
}

// Elastic to a fifth of its strength, and stopped there.
TEST_F(StrengthTable, HasNoStrengthOfATestThatDidNotFail) {
    Recipe recipe{.peak = 25e6, .drop = 0, .stop_reason = "strain limit"};
    const std::vector files{run("whole.h5"), run("short.h5", recipe)};
    test::expect_golden(test::narrow(table_of(files, TableFormat::aligned)));  // no mean, since one has a strength
    const std::string summary = test::written(write_strength_summary, files, TableFormat::tsv, notes_, StrengthKind::first_peak);
    EXPECT_EQ(field(summary, "runs") + field(summary, "runs_without_peak"), "21");
    EXPECT_NEAR(number_in(summary, "strength_MPa"), 125, 1);
    test::expect_golden(notes_.str(), "notes");
    for (const char* test : {"brazilian", "tension"}) {
        recipe.test = test;
        EXPECT_EQ(field(table_of(recipe), "tensile_strength_MPa"), "") << test;
    }
}

TEST_F(StrengthTable, HasColumnsOfTheOptionsThatAStudyVaried) {
    Recipe recipe;
    recipe.specimen.settings = {{"edge", 0.004, Dimension::length}, {"tessellation", std::string("delaunay")}};
    const std::vector files{run("a.h5", recipe), run("b.h5")};
    const auto table_with = [&](const std::vector<std::string>& options, TableFormat format) {
        return table_of(files, format, {}, ColumnChoice::usual, options);
    };
    const std::string table = table_with({"contact-cohesion,edge", "tessellation", "seed"}, TableFormat::tsv);
    EXPECT_EQ(field(table, "contact_cohesion_MPa", 1), "74.57");
    EXPECT_EQ(field(table, "edge_mm"), "4");
    EXPECT_EQ(field(table, "edge_mm", 1), "");
    EXPECT_EQ(field(table, "tessellation"), "delaunay");
    EXPECT_EQ(table.find("seed"), table.rfind("seed", table.find('\n')));  // once
    test::expect_golden(test::narrow(table_with({"edge"}, TableFormat::aligned)));
    test::GoldenRefusals("refusals").add<UsageError>("grain-size", [&] { (void)table_with({"grain-size"}, TableFormat::tsv); });
}

TEST_F(StrengthTable, HasEquation18OfTheForcesOfADisc) {
    const Recipe recipe{.test = "brazilian", .peak = 8.7e6, .specimen = test::grid_specimen(6, 6, 0.08, 0.08)};
    const std::string table = table_of(recipe);
    EXPECT_EQ(field(table, "peak_compressive_stress_MPa"), "");
    EXPECT_EQ(field(table, "tensile_strength_MPa"), "8.7");
    // The same from the largest force of the history: 2 Fmax/(π t D), t = 1 m.
    double largest = 0;
    const History history = test::synthetic_history(recipe);
    for (std::size_t i = 0; i < history.size(); ++i) {
        largest = std::max(largest, -(history[HistoryColumn::force_top][i] + history[HistoryColumn::force_bottom][i]) / 2);
    }
    EXPECT_NEAR(number_in(table, "tensile_strength_MPa"), 2 * largest / (std::numbers::pi * 0.08) * 1e-6, 1e-5);
}

TEST_F(StrengthTable, HasOneRowARunOrIsNotWritten) {
    const std::string first = run("a.h5");
    EXPECT_EQ(test::parse_tsv(table_of({first, run("b.h5")}, TableFormat::tsv)).size(), 3U);
    std::ostringstream nothing;
    EXPECT_THROW(write_strength_table(nothing, {first, folder_.file("missing.h5")}, TableFormat::tsv, notes_), InputError);
    EXPECT_EQ(nothing.str(), "");
}

TEST_F(StrengthTable, HasGroupsUnitsAndMeansInATerminalAndCountsATestOnce) {
    std::vector<std::string> files;
    Recipe recipe;
    const auto add = [&](const std::string& name, double peak) {
        recipe.peak = peak;
        recipe.specimen.seed = static_cast<std::int64_t>(files.size() + 1);
        files.push_back(run(name, recipe));
    };
    add("first.h5", 125e6);  // 124.4 of the smoothed curve
    add("second.h5", 135e6);
    recipe.material = "Gabbro";
    add("gabbro.h5", 285e6);
    recipe.test = "triaxial";
    recipe.confining_pressure = 5e6;
    add("third.h5", 200e6);
    files.push_back(folder_.file("again.h5"));
    std::filesystem::copy(files[0], files.back());
    const std::string table = test::narrow(table_of(files, TableFormat::aligned));
    test::expect_golden(table + notes_.str());
}

TEST_F(StrengthTable, HasStrainCracksAndEndOfTheStrengthAskedFor) {
    const Recipe recipe{.drop = 0.2, .hardens_to = 150e6, .stop_reason = "strain limit"};
    const std::string of_first_peak = table_of(recipe);
    const std::string of_largest = table_of(recipe, StrengthKind::largest);
    const auto both = [&](const char* column) { return std::pair(field(of_first_peak, column), field(of_largest, column)); };
    EXPECT_EQ(both("peak_compressive_stress_MPa"), std::pair(std::string("150"), std::string("150")));
    EXPECT_EQ(both("peak_kind"), std::pair(std::string("drop"), std::string("cap")));
    const auto [first_load, largest_load] = both("peak_load_kN/m");
    EXPECT_NEAR(std::stod(first_load), 125e3 * recipe.specimen.width, 0.01 * 125e3 * recipe.specimen.width);
    EXPECT_NEAR(std::stod(largest_load), 150e3 * recipe.specimen.width, 1e-6 * 150e3);
    for (const char* column : {"strain_at_peak", "tensile_cracks", "shear_cracks"}) {
        const auto [first, largest] = both(column);
        EXPECT_GT(std::stod(largest), std::stod(first)) << column;
    }
}

TEST_F(StrengthTable, HasNotesOfCaveats) {
    table_of({});
    EXPECT_EQ(notes_.str(), "");
    table_of({.drop = 0, .stop_reason = "strain limit"});
    // In rock direct tension is 0.7 to 0.9 times the Brazilian strength.
    for (const double tension : {7e6, 12e6}) {
        notes_ << "tension " << tension << " Pa:\n";
        table_of({run("t.h5", {.test = "tension", .peak = tension}), run("b.h5", {.test = "brazilian", .peak = 8e6})},
                 TableFormat::tsv);
    }
    test::expect_golden(notes_.str());
}

/// `strength --summary` of runs in files 0, 1, …, as TSV.
std::string summary_of(const std::vector<Recipe>& recipes, std::ostream& notes) {
    const test::TemporaryFolder folder;
    std::vector<std::string> files;
    for (const Recipe& recipe : recipes) {
        files.push_back(folder.file(std::to_string(files.size())));
        test::write_run(files.back(), recipe);
    }
    return test::written(write_strength_summary, files, TableFormat::tsv, notes, StrengthKind::first_peak);
}

TEST(StrengthSummary, HasMeansDeviationsAndRatiosByTest) {
    std::ostringstream notes;
    const std::string table = summary_of({{.test = "uniaxial", .peak = 120e6},
                                          {.test = "uniaxial", .peak = 130e6},
                                          {.test = "brazilian", .plane = PlaneCondition::stress, .peak = 8e6},
                                          {.test = "brazilian", .plane = PlaneCondition::stress, .peak = 9e6},
                                          {.test = "brazilian", .plane = PlaneCondition::stress, .peak = 13e6},
                                          {.test = "tension", .peak = 6e6},
                                          {.test = "triaxial", .confining_pressure = 8e6, .peak = 200e6},
                                          {.test = "triaxial", .confining_pressure = 4e6, .peak = 150e6}},
                                         notes);
    EXPECT_EQ(test::parse_tsv(table).size(), 6U);
    EXPECT_EQ(field(table, "strength_MPa", 0), "10");
    // s = √7 MPa; t(0.975, 2) = 4.302653
    EXPECT_NEAR(number_in(table, "strength_deviation_MPa", 0), std::sqrt(7.0), 1e-6);
    EXPECT_NEAR(number_in(table, "strength_high_MPa", 0), 10 + 4.302653 * std::sqrt(7.0 / 3), 1e-4);
    EXPECT_EQ(field(table, "ratio_to_brazilian", 0), "");
    EXPECT_EQ(field(table, "test", 1), "tension");
    EXPECT_EQ(field(table, "ratio_to_brazilian", 1), "0.6");
    EXPECT_EQ(field(table, "strength_deviation_MPa", 1), "");
    EXPECT_NEAR(number_in(table, "ratio_to_brazilian", 2), 12.5, 0.1);
    EXPECT_EQ(field(table, "confining_pressure_MPa", 3), "4");
    EXPECT_EQ(field(table, "confining_pressure_MPa", 4), "8");
}

RunData run_of(const std::string& test, double diameter, double peak) {
    const test::TemporaryFolder folder;
    const PlaneCondition plane = test == "brazilian" ? PlaneCondition::stress : PlaneCondition::strain;
    test::write_run(folder.file("run.h5"), {.test = test, .plane = plane, .peak = peak});
    RunData run = read_run_data(folder.file("run.h5"));
    run.specimen.grain_diameter = diameter;
    return run;
}

TEST(StrengthGroups, AreOfOneSizeEach) {
    const std::vector<RunData> runs{run_of("uniaxial", 5.01e-3, 100e6), run_of("brazilian", 5e-3, 8e6),
                                    run_of("uniaxial", 7e-3, 130e6), run_of("uniaxial", 4.98e-3, 110e6)};
    const auto rows = group_strengths(runs);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].test, "brazilian");
    EXPECT_NEAR(rows[1].strength.mean.value, 105e6, 1e6);
    EXPECT_EQ(rows[1].runs, (std::vector<std::size_t>{0, 3}));
    test::expect_golden(rows[1].distinction + "\n" + rows[2].distinction);
    EXPECT_FALSE(rows[2].ratio_to_brazilian.has_value());  // no disc of that size
    EXPECT_EQ(group_strengths({runs[0], runs[3]})[0].distinction, "");
}

TEST(StrengthGroups, HaveNamesOfTheirDifferences) {
    std::vector<RunData> runs{run_of("uniaxial", 5e-3, 100e6), run_of("uniaxial", 5e-3, 100e6), run_of("uniaxial", 7e-3, 100e6),
                              run_of("tension", 5e-3, 8e6)};
    runs[1].header.contact_law = "other";
    std::string names;
    for (const std::string& name : names_apart(runs)) names += name + "\n";
    runs[1] = runs[0];
    runs[0].name = "a/x.h5";
    runs[1].name = "a/y.h5";
    for (const std::string& name : names_apart({runs[0], runs[1]})) names += name + "\n";
    test::expect_golden(names);
}

TEST(StrengthSummary, HasARowForEachGroupAndCountsATestOnce) {
    std::ostringstream notes;
    const std::string table = summary_of({{}, {}, {.specimen = test::grid_specimen(16, 16, 0.16, 0.16)}}, notes);
    EXPECT_EQ(test::parse_tsv(table).size(), 3U) << table;
    EXPECT_EQ(field(table, "runs"), "1");
    EXPECT_EQ(field(table, "differs_in"), "width 80 mm");
    EXPECT_EQ(field(table, "differs_in", 1), "width 160 mm");
    test::expect_golden(notes.str());
}

}  // namespace
}  // namespace graincrack
