// The table of properties beside the laboratory's, of tests with known numbers.
#include "post/report/comparison.hpp"

#include <gtest/gtest.h>

#include "post/measure/toughness.hpp"
#include "post/report/html.hpp"
#include "post/report/test_report.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/synthetic_kind.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

class Comparison : public ::testing::Test {
protected:
    TestReport& add(const std::string& test, std::int64_t seed, double peak, double confining = 0, double width = 0.08) {
        test::Recipe recipe;
        recipe.test = test;
        recipe.peak = peak;
        recipe.confining_pressure = confining;
        recipe.specimen = test::grid_specimen(static_cast<int>(std::lround(100 * width)), 16, width, 0.16);
        recipe.specimen.seed = seed;
        const std::string file = folder_.file(std::to_string(tests_.size()) + ".h5");
        test::write_run(file, recipe);
        tests_.push_back(read_test_report(RunReader(file)));
        return tests_.back();
    }
    [[nodiscard]] std::string table(const std::optional<Material>& material) const {
        return comparison(seed_groups(tests_), {}, material);
    }
    static void expect_texts(const std::string& page, const std::vector<std::string>& words) {
        for (const std::string& each : words) EXPECT_NE(page.find(each), std::string::npos) << each << "\n" << page;
    }
    test::TemporaryFolder folder_;
    std::vector<TestReport> tests_;
};

TEST_F(Comparison, HasTargetsAndWhetherMeansAreWithinTheirDeviation) {
    for (const std::int64_t seed : {1, 2, 3}) {
        TestReport& test = add("uniaxial", seed, (119 + static_cast<double>(seed)) * 1e6);
        test.thresholds->pseudo_3d.initiation_by_crack_strain = 80e6 + static_cast<double>(seed) * 1e5;
        test.thresholds->initiation_by_count = 50e6;
        test.thresholds->pseudo_3d.damage = (100 + 10 * static_cast<double>(seed)) * 1e6;  // 120 ± 25
    }
    add("triaxial", 1, 200e6, 8e6);
    const std::string html = table(read_material("augig-granite-triangles"));
    const std::string uniaxial =
        "<td>UCS</td><td>122 ± 6.1\u00a0MPa</td><td>120.4\u00a0MPa\n112.7 to 128.2 "  // 118 to 122.9 by their own scatter
        "(3\u00a0runs, scatter of the calibration)</td><td>-1.3\u00a0%</td><td>not decided (3 runs)</td><td>fitted</td>";
    const std::string triaxial =
        "<td>σ1 at σ3 = 8 MPa</td><td>193.5 ± "
        "15\u00a0MPa</td><td>199.4\u00a0MPa\n";
    expect_texts(html,
                 {uniaxial, triaxial, "<td>crack initiation CI</td><td>55 ± 12\u00a0MPa</td><td>80.2\u00a0MPa\n",
                  "<td>outside</td><td>predicted</td>", "<td>crack damage CD</td><td>98 ± 18\u00a0MPa</td><td>120\u00a0MPa\n",
                  "<td>not decided (3 runs)</td><td>predicted</td>",
                  "<td>σ1 at σ3 = 20 MPa</td><td>300.7 ± 24\u00a0MPa</td><td colspan=\"4\">not tested</td>",
                  "<td>Brazilian tensile strength</td><td>8.8 ± 0.44\u00a0MPa</td><td colspan=\"4\">not tested</td>",
                  "1 within, 2 outside, 3 not decided"});
}

TEST_F(Comparison, ThresholdsAreThoseOfStrainGauges) {
    AllThresholds& thresholds = *add("uniaxial", 1, 120e6).thresholds;
    thresholds.pseudo_3d.initiation_by_crack_strain = 80e6;
    thresholds.pseudo_3d.damage = 110e6;
    thresholds.initiation_by_count = 60e6;
    const std::string html = table(std::nullopt);
    expect_texts(html, {"<th>property</th><th>computed", "<td>crack initiation CI</td><td>80\u00a0MPa",
                        "<td>crack damage CD</td><td>110\u00a0MPa", "as strain gauges tell them"});
    EXPECT_EQ(html.find("not tested"), std::string::npos);
}

TEST_F(Comparison, MeansOverSeedsHaveTheDefaultThresholds) {
    for (const std::int64_t seed : {1, 2}) {
        AllThresholds& thresholds = *add("uniaxial", seed, 120e6).thresholds;
        thresholds.pseudo_3d.initiation_by_crack_strain = static_cast<double>(60 + 10 * seed) * 1e6;
        thresholds.pseudo_3d.damage = static_cast<double>(90 + 10 * seed) * 1e6;
        thresholds.plane = {};
        thresholds.initiation_by_count = {};
    }
    // 120 ± 12.7 √50/√2: t(0.975, 1) = 12.7
    expect_texts(
        group_table(seed_groups(tests_)),
        {"<th>CI, MPa</th><th>CD, MPa</th>", "<td>uniaxial</td><td>strain</td><td>2</td>", "<td>75 (7.1)\n", "<td>105 (7.1)\n"});
}

TEST_F(Comparison, TheKindOfRockSaysWhatASpecimenHas) {
    add("uniaxial", 1, 120e6);
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    const Material rock = read_material(test::rock_by_kind_alone(folder_));
    const auto cell = [&](const char* name) {
        const auto found = KindSurface::of(rock)->predict(rock, property_named(name), 0);
        const auto at = [&](double deviations) { return html::number(found->specimen_at(deviations) * 1e-6); };
        const std::string specimen = KindSurface::specimen_of(property_named(name));
        return "<td>" + at(0) + "\u00a0MPa\n" + at(-1.959964) + " to " + at(1.959964) + (specimen.empty() ? "" : "\n") +
               specimen + "</td></tr>";
    };
    const std::string untested = "not tested</td><td>–</td><td>–</td><td>–</td>";
    expect_texts(table(rock),
                 {"median, 95\u00a0%</th>", cell("uniaxial"), untested + cell("brazilian"), "by the surface of granite"});
    Material strong = rock;
    strong.ratios.cohesion = 20;
    expect_texts(table(strong), {"predicts nothing of this material: its cohesion over tc is 20, those of the design 1."});
    EXPECT_EQ(table(strong).find("median"), std::string::npos);
    const std::string none = table(read_material("augig-granite"));
    expect_texts(none, {"The kind predicts nothing of this material: its contact.law is not given"});
    EXPECT_EQ(none.find("median"), std::string::npos);
}

TEST_F(Comparison, ACountOfCracksIsATargetOfItsOwn) {
    TestReport& test = add("uniaxial", 1, 120e6);
    test.thresholds->pseudo_3d.initiation_by_crack_strain = 80e6;
    test.thresholds->initiation_by_count = 60e6;
    EXPECT_EQ(value_of(test, calibrate::target_of("crack_initiation", "test")), 80e6);
    EXPECT_EQ(value_of(test, calibrate::target_of("crack_initiation_count", "test")), 60e6);
}

TEST_F(Comparison, ToughnessIsThatOfHalfDiscsWithASlit) {
    test::Recipe recipe;
    recipe.test = "bend";
    recipe.span = 0.048;
    recipe.specimen = test::grid_specimen(16, 8, 0.08, 0.04);
    recipe.specimen.shape = "half-disc";
    recipe.peak = 0.5e6;
    const auto report = [&] {
        test::write_run(folder_.file("bent.h5"), recipe);
        return read_test_report(RunReader(folder_.file("bent.h5")));
    };
    const calibrate::Target target = calibrate::target_of("toughness", "test");
    EXPECT_FALSE(value_of(report(), target));  // without a slit
    test::break_contacts(recipe.specimen, [](double x, double y) { return std::abs(x) < 1e-9 && y < 1e-9; });
    const double expected = half_disc_intensity(0.5e6 * 0.08, 0.02, 0.048, 0.04);
    tests_.push_back(report());
    EXPECT_NEAR(value_of(tests_.back(), target).value(), expected, 1e-5 * expected);
    tests_.back().mode_i_toughness = 1.2e6;
    Material rock = read_material("augig-granite");
    rock.laboratory["mode_i_toughness"] = 1.3e6;
    const std::string value = "<td>fracture toughness K_IC</td><td>1.3 ± 0.13*\u00a0MPa√m\n";
    const std::string computed = "</td><td>1.2\u00a0MPa√m\n(1\u00a0run)</td><td>-7.7\u00a0%</td><td>";
    expect_texts(table(rock), {value + "of a size that the material does not name" + computed + "size not known</td>"});
    rock.toughness_test = usual_half_disc(0.08);
    expect_texts(table(rock), {value + rock.toughness_test.text() + computed + "not decided by one run</td>"});
    rock.toughness_test = usual_half_disc(0.1);
    expect_texts(table(rock), {value + rock.toughness_test.text() + computed + "other specimen</td>"});
    tests_.back().bend.method = "beam";
    EXPECT_FALSE(value_of(tests_.back(), target));
}

TEST_F(Comparison, AVerdictNeedsTheWholeInterval) {
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
TEST_F(Comparison, OneRunIsJudgedByTheScatterThatItsCalibrationFound) {
    Material rock = read_material("augig-granite");
    add("uniaxial", 1, 122e6);
    const auto row = [&] { return table(rock).substr(table(rock).find("<td>UCS")); };
    EXPECT_TRUE(
        row().starts_with("<td>UCS</td><td>122 ± 6.1*\u00a0MPa</td><td>121.4\u00a0MPa\n(1\u00a0run)</td><td>-0.5\u00a0%</td>"
                          "<td>not decided by one run</td>"))
        << row();
    rock.fitted = {{"compressive_strength", "122 MPa; 121 (118.5 to 123.5) on 4 new specimens"}};
    EXPECT_TRUE(row().starts_with(
        "<td>UCS</td><td>122 ± 6.1*\u00a0MPa</td><td>121.4\u00a0MPa\n116.4 to 126.4 (1\u00a0run, scatter of the "
        "calibration)</td><td>-0.5\u00a0%</td><td>within</td><td>fitted</td>"))
        << row();
}

TEST_F(Comparison, TwoRunsHaveTheScatterOfTheCalibrationToo) {
    Material rock = read_material("augig-granite");
    rock.fitted = {{"compressive_strength", "122 MPa; 121 (118.5 to 123.5) on 4 new specimens"}};
    add("uniaxial", 1, 122e6);
    add("uniaxial", 2, 123e6);
    expect_texts(table(rock), {"(2\u00a0runs, scatter of the calibration)</td><td>-0.0\u00a0%</td><td>within</td>"});
}

TEST_F(Comparison, WhatTheLaboratoryDoesNotHaveIsNotPredicted) {
    add("uniaxial", 1, 122e6);
    Material rock = read_material("augig-granite");
    rock.fitted = {{"compressive_strength", "122 MPa; 121 (118.5 to 123.5) on 4 new specimens"}};
    EXPECT_NE(table(rock).find("<td>predicted</td>"), std::string::npos);  // E
    rock.laboratory.clear();
    EXPECT_EQ(table(rock).find("predicted</td>"), std::string::npos);
}

TEST_F(Comparison, ATestThatDidNotFailHasNoStrength) {
    add("uniaxial", 1, 120e6);
    Strength& strength = add("uniaxial", 2, 30e6).strength;
    strength.strength.reset();
    strength.peak_kind = "cap";
    const std::vector<SeedGroup> groups = seed_groups(tests_);
    EXPECT_EQ(groups[0].sample_of(strength_of)->n, 1U);
    expect_texts(table(read_material("augig-granite")), {"<td>UCS</td><td>122 ± 6.1*\u00a0MPa</td><td>119.4\u00a0MPa"});
    expect_texts(group_table(groups),
                 {"<th>did not fail</th>", "<td>uniaxial</td><td>strain</td><td>2</td><td>119.4</td><td>0.4708</td>"});
}

TEST_F(Comparison, HeatedSpecimensStandBesideNeitherLaboratoryNorKind) {
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    const Material rock = read_material("wausau-granite-calibrated");
    const auto row = [&](const std::string& name) {
        const std::string page = table(rock);
        const std::size_t from = page.find("<td>" + name + "</td>");
        return from == std::string::npos ? "" : page.substr(from, page.find("</tr>", from) - from);
    };
    add("uniaxial", 1, 120e6).data.header.heat = 300;
    const std::string heated = "UCS, at +300 K", none = "<td>–</td>";
    EXPECT_EQ(row(heated),
              "<td>" + heated + "</td>" + none + "<td>119.4\u00a0MPa\n(1\u00a0run)</td>" + none + none + none + none);
    add("uniaxial", 1, 120e6);
    EXPECT_TRUE(row(heated).ends_with(none + none + none + none)) << row(heated);
    EXPECT_NE(row("UCS").find("226 ± "), std::string::npos) << row("UCS");
    expect_texts(table(rock), {"Heated specimens stand beside neither"});
}

TEST_F(Comparison, TwoTestsDoNotDetermineALine) {
    EnvelopeTests two;
    two.compression = {{0, 120e6, 1}, {8e6, 190e6, 1}};
    add("uniaxial", 1, 120e6);
    const FabricEnvelope line{"", false, two, fit_envelope(two.confining(), two.strength())};
    const std::string html = comparison(seed_groups(tests_), {line}, read_material("augig-granite"));
    expect_texts(html, {"<td>friction angle φ</td><td>53\u00a0°</td><td>not determined by 2 tests</td>"});
}

TEST_F(Comparison, SpecimensOfAnotherWidthAreAnotherGroup) {
    add("uniaxial", 1, 120e6);
    add("uniaxial", 2, 130e6);
    add("uniaxial", 1, 110e6, 0, 0.04);
    add("triaxial", 1, 200e6, 8e6);
    const std::vector<SeedGroup> groups = seed_groups(tests_);
    ASSERT_EQ(groups.size(), 3U);
    EXPECT_EQ(groups[0].name(), "uniaxial, width 80 mm");
    EXPECT_NEAR(groups[0].sample_of(strength_of)->mean.value, 125e6, 1e6);
    EXPECT_EQ(groups[0].sample_of([](const MeasuredRun&) { return std::nullopt; }), std::nullopt);
    EXPECT_EQ(groups[1].name(), "uniaxial, width 40 mm");
    EXPECT_EQ(groups[2].name(), "σ3 = 8 MPa");
    expect_texts(table(std::nullopt), {"<td>UCS, width 80 mm</td>", "<td>UCS, width 40 mm</td>"});
}

TEST(FittedTable, HasTheWordsOfALaboratory) {
    const std::string table = fitted_table(read_material("augig-granite-triangles"));
    EXPECT_NE(table.find("<td>UCS</td><td>122 MPa</td><td>124.6\u00a0MPa</td><td>117.6 to 131.6</td><td>6</td>"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("<td>Poisson's ratio ν</td><td>0.23</td><td>0.2293</td>"), std::string::npos) << table;
    EXPECT_EQ(table.find('_'), std::string::npos) << table;
    EXPECT_EQ(fitted_table(read_material("augig-granite")), "");
    EXPECT_EQ(fitted_table(std::nullopt), "");
    Material other;
    other.fitted = {{"confined_strength", "by hand"}, {"p_wave_speed", "4 km/s; 4.1 on 1 new specimen"}};
    const std::string words = fitted_table(other);
    EXPECT_NE(words.find("<td>confined strength</td><td colspan=\"4\">by hand</td>"), std::string::npos) << words;
    EXPECT_NE(words.find("<td>p wave speed</td><td>4 km/s</td><td>4.1</td><td>–</td><td>1</td>"), std::string::npos) << words;
}

}  // namespace
}  // namespace graincrack
