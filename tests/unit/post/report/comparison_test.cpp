// The table of properties beside the laboratory's, of tests with known numbers.
#include "post/report/comparison.hpp"

#include <gtest/gtest.h>

#include "post/measure/toughness.hpp"
#include "post/report/html.hpp"
#include "post/report/test_report.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/page_text.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/synthetic_kind.hpp"

namespace graincrack {
namespace {

class Comparison : public test::RunFolder {
protected:
    TestReport& add(const std::string& test, std::int64_t seed, double peak, double confining = 0, double width = 0.08) {
        test::Recipe recipe{.test = test, .confining_pressure = confining, .peak = peak};
        recipe.specimen = test::grid_specimen(static_cast<int>(std::lround(100 * width)), 16, width, 0.16);
        recipe.specimen.seed = seed;
        tests_.push_back(read_test_report(RunReader(run(std::to_string(tests_.size()) + ".h5", recipe))));
        return tests_.back();
    }
    /// A compression test whose thresholds are planted.
    void add_thresholds(std::int64_t seed, double peak, double initiation, double damage) {
        AllThresholds& thresholds = *add("uniaxial", seed, peak).thresholds;
        thresholds.pseudo_3d.initiation_by_crack_strain = initiation;
        thresholds.pseudo_3d.damage = damage;
        thresholds.plane = {};
        thresholds.initiation_by_count = 50e6;
    }
    [[nodiscard]] std::string table(const std::optional<Material>& material) const {
        return test::text_of_page(comparison(seed_groups(tests_), {}, material));
    }
    /// The row of a property.
    [[nodiscard]] std::string row(const Material& material, const std::string& property) const {
        const std::string text = table(material);
        const std::size_t from = text.find("\n" + property + " | ");
        return from == std::string::npos ? "" : text.substr(from + 1, text.find('\n', from + 1) - from);
    }
    std::vector<TestReport> tests_;
};

TEST_F(Comparison, HasTargetsAndWhetherMeansAreWithinTheirDeviation) {
    for (const std::int64_t seed : {1, 2, 3}) {  // CD: 120 ± 25
        const auto i = static_cast<double>(seed);
        add_thresholds(seed, (119 + i) * 1e6, 80e6 + i * 1e5, (100 + 10 * i) * 1e6);
    }
    add("triaxial", 1, 200e6, 8e6);
    test::expect_golden(table(read_material("augig-granite-triangles")));
}

TEST_F(Comparison, HasThresholdsOfStrainGaugesAndMeansOverSeeds) {
    add_thresholds(1, 120e6, 70e6, 100e6);
    test::expect_golden(table(std::nullopt));
    add_thresholds(2, 120e6, 80e6, 110e6);
    // 120 ± 12.7 √50/√2: t(0.975, 1) = 12.7
    test::expect_golden(test::text_of_page(group_table(seed_groups(tests_))), "means");
}

TEST_F(Comparison, HasWhatTheKindOfRockSaysOfASpecimen) {
    add("uniaxial", 1, 120e6);
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    const Material rock = read_material(test::rock_by_kind_alone(folder_));
    for (const char* const name : {"uniaxial", "brazilian"}) {
        const auto found = KindSurface::of(rock)->predict(rock, property_named(name), 0);
        const auto at = [&](double deviations) { return html::number(found->specimen_at(deviations) * 1e-6); };
        const std::string interval = at(0) + "\u00a0MPa / " + at(-1.959964) + " to " + at(1.959964);
        EXPECT_NE(table(rock).find(" | " + interval), std::string::npos) << interval << "\n" << table(rock);
    }
    test::expect_golden(table(rock));
    Material strong = rock;
    strong.ratios.cohesion = 20;
    test::expect_golden(table(strong), "cohesion beyond the design");
    test::expect_golden(table(read_material("augig-granite")), "no contact law");
}

TEST_F(Comparison, TakesACountOfCracksAsATargetOfItsOwn) {
    add_thresholds(1, 120e6, 80e6, 110e6);
    EXPECT_EQ(value_of(tests_[0], calibrate::target_of("crack_initiation", "test")), 80e6);
    EXPECT_EQ(value_of(tests_[0], calibrate::target_of("crack_initiation_count", "test")), 50e6);
}

TEST_F(Comparison, HasTheToughnessOfHalfDiscsWithASlit) {
    test::Recipe recipe{.test = "bend", .peak = 0.5e6, .specimen = test::grid_specimen(16, 8, 0.08, 0.04), .span = 0.048};
    recipe.specimen.shape = "half-disc";
    const auto report = [&] { return read_test_report(RunReader(run("bent.h5", recipe))); };
    const calibrate::Target target = calibrate::target_of("toughness", "test");
    EXPECT_FALSE(value_of(report(), target));  // without a slit
    test::break_contacts(recipe.specimen, [](double x, double y) { return std::abs(x) < 1e-9 && y < 1e-9; });
    const double expected = half_disc_intensity(0.5e6 * 0.08, 0.02, 0.048, 0.04);
    tests_.push_back(report());
    EXPECT_NEAR(value_of(tests_.back(), target).value(), expected, 1e-5 * expected);
    tests_.back().mode_i_toughness = 1.2e6;
    Material rock = read_material("augig-granite");
    rock.laboratory["mode_i_toughness"] = 1.3e6;
    std::string rows = row(rock, "fracture toughness K_IC");
    for (const double diameter : {0.08, 0.1}) {
        rock.toughness_test = usual_half_disc(diameter);
        rows += row(rock, "fracture toughness K_IC");
    }
    test::expect_golden(rows);
    tests_.back().bend.method = "beam";
    EXPECT_FALSE(value_of(tests_.back(), target));
}

TEST_F(Comparison, NeedsTheWholeIntervalForAVerdict) {
    calibrate::Target target = calibrate::target_of("uniaxial", "test");
    target.value = 100;
    target.deviation = 5;
    const auto verdict = [&](const std::vector<double>& values) { return name_of(agreement_of(target, sample(values).mean)); };
    EXPECT_EQ(verdict({100}), "undecided");
    EXPECT_EQ(verdict({106}), "undecided");
    EXPECT_EQ(verdict({99.9, 100.1}), "within");
    EXPECT_EQ(verdict({95, 105}), "undecided");  // 37 to 163
    EXPECT_EQ(verdict({106, 108}), "undecided");
    EXPECT_EQ(verdict({109.9, 110.1}), "outside");
    target.deviation = NAN;
    EXPECT_EQ(verdict({106, 107}), "");
}

// 118.5 to 123.5 of 4 specimens: s = 1.57 MPa, and t s = 5 MPa about a single one.
TEST_F(Comparison, JudgesFewRunsByTheScatterThatTheirCalibrationFound) {
    Material rock = read_material("augig-granite");
    add("uniaxial", 1, 122e6);
    std::string rows = row(rock, "UCS");
    rock.fitted = {{"compressive_strength", "122 MPa; 121 (118.5 to 123.5) on 4 new specimens"}};
    rows += row(rock, "UCS") + row(rock, "Young's modulus E");
    add("uniaxial", 2, 123e6);
    rows += row(rock, "UCS");
    rock.laboratory.clear();  // what it does not have is not predicted
    test::expect_golden(rows + table(rock));
}

TEST_F(Comparison, HasNoStrengthOfATestThatDidNotFail) {
    add("uniaxial", 1, 120e6);
    Strength& strength = add("uniaxial", 2, 30e6).strength;
    strength.strength.reset();
    strength.peak_kind = "cap";
    const std::vector<SeedGroup> groups = seed_groups(tests_);
    EXPECT_EQ(groups[0].sample_of(strength_of)->n, 1U);
    test::expect_golden(row(read_material("augig-granite"), "UCS") + test::text_of_page(group_table(groups)));
}

TEST_F(Comparison, HasHeatedSpecimensBesideNeitherLaboratoryNorKind) {
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    const Material rock = read_material("wausau-granite-calibrated");
    add("uniaxial", 1, 120e6).data.header.heat = 300;
    const std::string alone = row(rock, "UCS, at +300 K");
    add("uniaxial", 1, 120e6);
    test::expect_golden(alone + row(rock, "UCS, at +300 K") + row(rock, "UCS"));
    const std::string text = table(rock);
    test::expect_golden(text.substr(text.rfind("Heated")), "note");
}

TEST_F(Comparison, HasNoLineOfTwoTests) {
    EnvelopeTests two;
    two.compression = {{0, 120e6, 1}, {8e6, 190e6, 1}};
    add("uniaxial", 1, 120e6);
    const FabricEnvelope line{"", false, two, fit_envelope(two.confining(), two.strength())};
    test::expect_golden(test::text_of_page(comparison(seed_groups(tests_), {line}, read_material("augig-granite"))));
}

TEST_F(Comparison, GroupsSpecimensByTheirWidth) {
    add("uniaxial", 1, 120e6);
    add("uniaxial", 2, 130e6);
    add("uniaxial", 1, 110e6, 0, 0.04);
    add("triaxial", 1, 200e6, 8e6);
    const std::vector<SeedGroup> groups = seed_groups(tests_);
    ASSERT_EQ(groups.size(), 3U);
    EXPECT_NEAR(groups[0].sample_of(strength_of)->mean.value, 125e6, 1e6);
    EXPECT_EQ(groups[0].sample_of([](const MeasuredRun&) { return std::nullopt; }), std::nullopt);
    test::expect_golden(table(std::nullopt) + groups[0].name() + "\n" + groups[1].name() + "\n" + groups[2].name());
}

TEST(FittedTable, HasTheWordsOfALaboratory) {
    Material other;
    other.fitted = {{"confined_strength", "by hand"}, {"p_wave_speed", "4 km/s; 4.1 on 1 new specimen"}};
    test::expect_golden(test::text_of_page(fitted_table(read_material("augig-granite-triangles"))));
    test::expect_golden(test::text_of_page(fitted_table(other)), "by hand");
    EXPECT_EQ(fitted_table(read_material("augig-granite")), "");
    EXPECT_EQ(fitted_table(std::nullopt), "");
}

}  // namespace
}  // namespace graincrack
