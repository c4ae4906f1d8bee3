// Properties of specimens beside the laboratory's: means, the line and the numbers that follow, against numbers by hand.
#include "post/laboratory/comparison.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "post/calibrate/predicted.hpp"
#include "share/base/error.hpp"
#include "share/rock/material_edit.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/synthetic_kind.hpp"

namespace graincrack {
namespace {

using test::field;
using test::Recipe;

constexpr double degree = M_PI / 180;

/// Some columns of a table. \param most rows
std::string cells(const std::string& table, const std::vector<std::string>& columns, std::size_t most = 1000) {
    std::string text;
    for (std::size_t row = 0; row + 1 < test::parse_tsv(table).size() && row < most; ++row) {
        for (const std::string& column : columns) text += (column == columns[0] ? "" : "\t") + field(table, column, row);
        text += "\n";
    }
    return text;
}

class Properties : public test::RunFolder {
protected:
    void add(const std::string& test, std::int64_t seed, double peak, double confining = 0) {
        Recipe recipe{.test = test, .confining_pressure = confining, .peak = peak};
        recipe.specimen.seed = seed;
        if (test == "brazilian") recipe.specimen.shape = "disc";
        files_.push_back(run(std::to_string(files_.size()) + ".h5", recipe));
    }
    [[nodiscard]] std::vector<ComparisonRow> rows(const std::vector<RunData>& runs, StrengthKind kind = StrengthKind::largest) {
        return property_rows(runs, {material_, {}, {}}, {.strength = kind}, why_);
    }
    [[nodiscard]] std::string table(const std::vector<RunData>& runs) {
        return test::written(write_properties, rows(runs), TableFormat::tsv);
    }
    [[nodiscard]] std::map<std::string, ComparisonRow> measured() {
        std::map<std::string, ComparisonRow> by_name;
        for (ComparisonRow& row : rows(read_runs(files_))) by_name[row.column] = row;
        return by_name;
    }
    /// A number of a row of the table.
    [[nodiscard]] double in_table(const std::string& property, const std::string& column) {
        const std::string text = table(read_runs(files_));
        for (std::size_t row = 0; row + 1 < test::parse_tsv(text).size(); ++row) {
            if (field(text, "property", row) == property) return std::stod(field(text, column, row));
        }
        ADD_FAILURE() << "no " << property;
        return NAN;
    }
    std::string why_;
    std::vector<std::string> files_;
    Material material_ = read_material("augig-granite");
};

TEST_F(Properties, AreOfComparableRunsOfTheMaterialAlone) {
    add("uniaxial", 1, 120e6);
    const std::vector<RunData> runs = read_runs(files_);
    const auto require = [&] { require_material(runs, {material_, {}, {}}); };
    material_.file = "rock.toml";
    material_.name = "Augig granite, calibrated";                                  // of another name
    material_.contact.cohesion = material_.contact.cohesion.value() * (1 + 2e-6);  // six digits in a file
    EXPECT_NO_THROW(require());
    EXPECT_NO_THROW(require_material(runs, {read_material("lac-du-bonnet-granite-calibrated"), {"contact.cohesion"}, {}}));
    test::GoldenRefusals refused;
    material_.contact.cohesion = 80e6;
    refused.add<InputError>("another material", require);
    material_.name = "Augig granite";
    refused.add<InputError>("another cohesion", require);
    files_.push_back(run("fine.h5", {.specimen = test::grid_specimen(16, 32, 0.08, 0.16)}));
    refused.add<InputError>("finer grains", [&] { (void)measured(); });
}

TEST_F(Properties, HaveTheScatterOfTheCalibrationInIntervalsOfUpToThreeRuns) {
    for (const std::int64_t seed : {1, 2}) add("brazilian", seed, seed == 1 ? 6e6 : 12e6);
    EXPECT_EQ(measured().size(), 1U);
    EXPECT_EQ(in_table("tensile_strength_MPa", "low"), 0);  // 9 ± 38 MPa
    // t(0.975, 4) = 2.776445: 2 MPa of 5 specimens. Pooled with √18 MPa of one degree of freedom: t(0.975, 5) = 2.570582.
    material_.fitted = {{"tensile_strength", "8.8 MPa; 9 (6.516674 to 11.483326) on 5 new specimens"}};
    const double half = 2.570582 * std::sqrt((18 + 4 * 4) / 5.0 / 2);
    EXPECT_NEAR(in_table("tensile_strength_MPa", "low"), 9 - half, 1e-4);
    EXPECT_NEAR(in_table("tensile_strength_MPa", "high"), 9 + half, 1e-4);
    EXPECT_NEAR(in_table("tensile_strength_MPa", "half_interval_percent"), 100 * half / 9, 1e-3);
    add("brazilian", 3, 9e6);
    EXPECT_NEAR(in_table("tensile_strength_MPa", "high"), 9 + 2.446912 * std::sqrt((18 + 4 * 4) / 6.0 / 3), 1e-4);
    add("brazilian", 4, 9e6);  // by their own: t(0.975, 3) = 3.182446
    EXPECT_NEAR(in_table("tensile_strength_MPa", "high"), 9 + 3.182446 * std::sqrt(6.0 / 4), 1e-4);
}

TEST_F(Properties, HaveMeansBesideTheLaboratorysValues) {
    add("uniaxial", 1, 120e6);
    add("uniaxial", 2, 130e6);
    add("brazilian", 1, 8e6);
    add("brazilian", 2, 9e6);
    add("brazilian", 3, 13e6);
    const auto found = measured();
    // Slopes of 26 GPa and 0.3 in plane strain: ν = 0.3/1.3, E = 26 (1 − ν²)
    EXPECT_NEAR(in_table("young_modulus_GPa", "ours"), 26 * (1 - std::pow(0.3 / 1.3, 2)), 1e-3);
    EXPECT_NEAR(found.at("poisson_ratio").ours.value, 0.3 / 1.3, 1e-5);
    EXPECT_EQ(in_table("young_modulus_GPa", "laboratory"), 25.8);
    const ComparisonRow& tension = found.at("tensile_strength_MPa");
    EXPECT_EQ(in_table("tensile_strength_MPa", "ours"), 10);
    EXPECT_NEAR(*tension.deviation, 1e6 * std::sqrt(7.0), 1e-3);
    const double half = 4.302653 * std::sqrt(7.0 / 3);  // t(0.975, 2)
    EXPECT_NEAR(*tension.ours.low, 10e6 - 1e6 * half, 10);
    EXPECT_NEAR(*tension.half_interval_percent(), 10 * half, 1e-4);
    EXPECT_NEAR(*tension.off_laboratory_percent(), 100 * (10 / 8.8 - 1), 1e-9);
    EXPECT_EQ(tension.specimens, 3U);
    EXPECT_EQ(tension.without_peak, 0U);
    EXPECT_EQ(tension.specimens_for_3_percent(), std::ceil(std::pow(1.96 * std::sqrt(7.0) / 0.3, 2)));
    EXPECT_EQ(in_table("s1_at_0_MPa", "laboratory"), 122);  // the UCS itself, not that of the line
    EXPECT_EQ(found.count("cohesion_MPa"), 0U);             // one pressure has no line
}

TEST_F(Properties, CompareTheLineWithTheLaboratorysLine) {
    const double b = (1 + std::sin(50 * degree)) / (1 - std::sin(50 * degree));
    const double a = 2 * 22e6 * std::sqrt(b);
    for (const std::int64_t seed : {1, 2}) {
        add("uniaxial", seed, a + (seed == 1 ? 1e6 : -1e6));
        add("triaxial", seed, a + 8e6 * b + (seed == 1 ? 1e6 : -1e6), 8e6);
    }
    const auto found = measured();
    EXPECT_NEAR(in_table("cohesion_MPa", "ours"), 22, 1e-3);
    EXPECT_NEAR(in_table("friction_angle_deg", "ours"), 50, 1e-3);
    EXPECT_NEAR(found.at("slope_b").ours.value, b, 1e-3);
    const double high = *found.at("friction_angle_deg").ours.high;
    EXPECT_NEAR(*found.at("slope_b").ours.high, (1 + std::sin(high)) / (1 - std::sin(high)), 1e-6);
    EXPECT_LT(*found.at("slope_b").ours.low, b);
    // Of the laboratory: C 21 MPa, φ 53°.
    const double laboratory_b = (1 + std::sin(53 * degree)) / (1 - std::sin(53 * degree));
    EXPECT_NEAR(in_table("s1_at_8_MPa", "laboratory"), 2 * 21 * std::sqrt(laboratory_b) + 8 * laboratory_b, 1e-4);
    EXPECT_NEAR(in_table("friction_angle_deg", "laboratory"), 53, 1e-9);
    EXPECT_NEAR(in_table("slope_b", "laboratory"), laboratory_b, 1e-6);
    EXPECT_EQ(found.at("cohesion_MPa").specimens, 4U);
    // Each seed has a line of its own: C = (a ± 1 MPa)/(2√b)
    EXPECT_NEAR(in_table("cohesion_MPa", "deviation"), std::sqrt(2.0) / (2 * std::sqrt(b)), 1e-3);
    EXPECT_EQ(found.at("cohesion_MPa").specimens_for_3_percent(), std::nullopt);  // no mean of specimens
}

TEST_F(Properties, AreADatasheetInATerminal) {
    add("uniaxial", 1, 120e6);
    add("brazilian", 1, 8e6);
    add("brazilian", 2, 12e6);
    test::expect_golden(test::written(write_properties, rows(read_runs(files_), StrengthKind::first_peak), TableFormat::aligned));
}

TEST_F(Properties, LeaveOutTestsThatDidNotFail) {
    add("uniaxial", 1, 120e6);
    add("uniaxial", 2, 26e6);
    std::vector<RunData> runs = read_runs(files_);
    runs[1].history = test::synthetic_history({.peak = 26e6, .drop = 0});
    runs[1].header.stop_reason = "strain limit";
    for (const ComparisonRow& row : rows(runs, StrengthKind::first_peak)) {
        if (row.column != "s1_at_0_MPa") continue;
        EXPECT_NEAR(row.ours.value, 120e6, 1e6);
        EXPECT_EQ(row.specimens, 1U);
        EXPECT_EQ(row.without_peak, 1U);
    }
}

TEST_F(Properties, AreEmptyWhereUnknown) {
    add("tension", 1, 6e6);
    add("uniaxial", 1, 120e6);
    material_.name = "Carrara marble";
    material_.laboratory.clear();
    test::expect_golden(table(read_runs(files_)));
}

TEST_F(Properties, HaveValuesOfTheKindOfRockWithoutRunsToo) {
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    const std::string file = test::rock_by_kind_alone(folder_);
    const IncompleteMaterial rock = read_incomplete_material(file);
    const Material whole = read_material(file);
    const double ucs = KindSurface::of(whole)->predict(whole, property_named("uniaxial"), 0)->value * 1e-6;
    const auto predicted = [&](const IncompleteMaterial& of) { return property_rows(read_runs(files_), of, {}, why_); };
    const std::string values = test::written(write_properties, predicted(rock), TableFormat::tsv);
    EXPECT_EQ(why_, "");
    test::expect_golden(cells(values, {"property", "ours", "laboratory"}));  // at the pressures of its [targets]
    EXPECT_NEAR(test::number_in(values, "kind_median", 2), ucs, 1e-4 * ucs);
    double last = 0;
    for (const char* column : {"kind_95_low", "kind_50_low", "kind_median", "kind_50_high", "kind_95_high"}) {
        const double value = test::number_in(values, column, 2);
        EXPECT_GT(value, last) << column;
        last = value;
    }
    add("uniaxial", 1, 120e6);
    const std::vector<ComparisonRow> tested = predicted(rock);
    EXPECT_EQ(tested[2].column, "s1_at_0_MPa");
    EXPECT_NEAR(tested[2].ours.value, 119.4e6, 1e5);
    EXPECT_NEAR(tested[2].kind->value, 1e6 * ucs, 1e-3 * ucs);
    (void)predicted(read_incomplete_material("augig-granite"));
    test::expect_golden(why_, "no kind");
}

TEST_F(Properties, HaveThePredictionsOfACalibrationUntilTheRockChanges) {
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    const std::string file = test::rock_by_kind_alone(folder_);
    const auto write = [&file](const std::string& text) { std::ofstream(file) << text; };
    const Material at = read_material(file);
    const auto predict = [&](double ucs) {
        const calibrate::Target target = calibrate::target_of("uniaxial", "test");
        write(calibrate::with_predictions(test::read_text(file), at, {{target, {}, {ucs, ucs / 1.2, ucs * 1.2}, {}}}));
    };
    const auto row_of = [&](const std::string& column) {
        const auto all = property_rows({}, read_incomplete_material(file), {}, why_);
        return *std::ranges::find(all, column, &ComparisonRow::column);
    };
    const auto ucs_of_kind = [&] { return *row_of("s1_at_0_MPa").kind; };
    const double by_kind = ucs_of_kind().value;
    predict(300e6);
    predict(212e6);  // in place of the earlier one
    EXPECT_NEAR(ucs_of_kind().value, 212e6, 1e4);
    EXPECT_NEAR(ucs_of_kind().specimen_at(deviations_of_95_percent), 212e6 * 1.2, 1e4);
    std::string specimens;
    for (const char* column : {"s1_at_0_MPa", "tensile_strength_MPa", "s1_at_8_MPa"}) {
        specimens += fmt::format("{}: {}\n", column, row_of(column).kind_specimen);
    }
    test::expect_golden(specimens);
    const KindPrediction of_discs = *KindSurface::of(at)->predict(at, property_named("brazilian"), 0);
    EXPECT_EQ(row_of("tensile_strength_MPa").kind->value, of_discs.value);
    write(material_with(file, {{"name", "the same"}}));
    EXPECT_NEAR(ucs_of_kind().value, 212e6, 1e4);
    write(material_with(file, {{"contact.tensile_strength", fmt::format("{} Pa", *at.contact.tensile_strength * 1.01)}}));
    EXPECT_NEAR(ucs_of_kind().value, 1.01 * by_kind, 0.01 * by_kind);
}

TEST_F(Properties, CompareHeatedSpecimensWithNeitherLaboratoryNorKind) {
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    add("uniaxial", 1, 120e6);
    add("triaxial", 1, 200e6, 8e6);
    std::vector<RunData> runs = read_runs(files_);
    for (RunData& run : runs) run.header.heat = 300;
    for (const std::string rock : {"augig-granite", "wausau-granite-calibrated"}) {
        const auto compared = property_rows(runs, read_incomplete_material(rock), {}, why_);
        const std::string values = test::written(write_properties, compared, TableFormat::tsv);
        const std::string heated =
            cells(values, {"property", "specimens", "laboratory", "off_laboratory_percent", "kind_median", "kind_95_high"}, 7);
        test::expect_golden(heated + "\n" + cells(values, {"property"}), rock);
    }
}

}  // namespace
}  // namespace graincrack
