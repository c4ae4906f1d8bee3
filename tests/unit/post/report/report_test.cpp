#include "post/report/report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "post/chart/picture.hpp"
#include "post/report/html.hpp"
#include "post/report/test_report.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

class Report : public ::testing::Test {
protected:
    std::string run(const std::string& name, const test::Recipe& recipe) {
        test::write_run(folder_.file(name), recipe);
        return folder_.file(name);
    }
    test::Recipe recipe(const std::string& test, double peak, double confining = 0) {
        test::Recipe r;
        r.test = test;
        r.peak = peak;
        r.confining_pressure = confining;
        if (test == "brazilian") r.plane = PlaneCondition::stress;
        return r;
    }
    std::string page(const std::vector<std::string>& runs, const ReportOptions& options = {}) {
        diagnostics_.str("");
        return make_report(runs, options, Verbosity::quiet, diagnostics_);
    }
    static void expect_texts(const std::string& page, const std::vector<std::string>& words) {
        for (const std::string& each : words) EXPECT_NE(page.find(each), std::string::npos) << each;
    }
    /// The cells of the row of a table that begins with a text.
    static std::string row_of(const std::string& page, const std::string& first) {
        const std::size_t from = page.find("<td>" + first + "</td>");
        return from == std::string::npos ? "" : page.substr(from, page.find("</tr>", from) - from);
    }
    /// Each attribute points into the page or carries its data.
    static void expect_own_references(const std::string& page, const std::string& attribute) {
        for (std::size_t i = page.find(attribute); i != std::string::npos; i = page.find(attribute, i + 1)) {
            const std::string value = page.substr(i + attribute.size(), 60);
            EXPECT_TRUE(value.starts_with("data:") || value.starts_with('#')) << value;
        }
    }
    test::TemporaryFolder folder_;
    std::ostringstream diagnostics_;
};

TEST(Figures, LeaveNoColumnEmpty) {
    const auto count = [](const std::string& text, const std::string& word) {
        std::size_t n = 0;
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
        return n;
    };
    html::Figures charts;
    std::vector<double> widths;
    for (std::size_t n = 1; n <= 3; ++n) {
        charts.add("chart", [&](const PictureStyle& style) {
            widths.push_back(style.page_width);
            return Drawing(10, 10);
        });
        widths.clear();
        const std::string html = charts.str();
        EXPECT_EQ(count(html, "<figure"), n);
        EXPECT_EQ(count(html, "<figure class=\"across\">"), n % 2);
        EXPECT_EQ(widths.front(), html::figure_style(n % 2 == 1).page_width);
        EXPECT_TRUE(n == 1 || widths.back() == html::figure_style().page_width);
    }
    html::Figures maps;
    const auto draw = [](const PictureStyle&) { return Drawing(10, 10); };
    maps.add_specimen("specimen", draw);
    EXPECT_EQ(count(maps.str(), "<figure class=\"middle\">"), 1U);
    maps.add_specimen("specimen", draw);
    EXPECT_EQ(count(maps.str(), "class=\"middle\""), 0U);
}

TEST_F(Report, ASetHasAllSectionsAndNothingFromElsewhere) {
    const std::string html = page({run("u.h5", recipe("uniaxial", 120e6)), run("t.h5", recipe("triaxial", 160e6, 4e6)),
                                   run("b.h5", recipe("brazilian", 9e6))},
                                  {.material = read_material("augig-granite")});
    for (const char* id :
         {"laboratory", "means", "curves", "quality-checks", "envelope", "maps", "mesh", "inputs", "provenance"}) {
        expect_texts(html, {"<h2 id=\"" + std::string(id) + "\">"});
    }
    // Namespaces of SVG are names, not addresses that are fetched.
    expect_own_references(html, "src=\"");
    expect_own_references(html, "href=\"");
    EXPECT_EQ(html.find("<script src"), std::string::npos);
    EXPECT_EQ(html.find("@import"), std::string::npos);
    // Laboratory: σt 8.8, UCS 122 MPa with the usual deviation of 5 %; σ1 at 4 MPa on the line UCS + b σ3, b = 8.93.
    expect_texts(
        html,
        {"<td>8.8 ± 0.44*\u00a0MPa</td><td>9\u00a0MPa\n(1\u00a0run)</td><td>+2.3\u00a0%</td><td>not decided by one run</td>",
         "<td>122 ± 6.1*\u00a0MPa</td><td>119.4\u00a0MPa\n(1\u00a0run)</td><td>-2.1\u00a0%</td><td>not decided by one run</td>",
         "<td>σ1 at σ3 = 4 MPa</td><td>157.7 ± 13*\u00a0MPa\nφ line, no test</td>", "Mohr–Coulomb", "13.3", "no potential",
         "0.2\u00a0%", "Density 2650 kg/m³"});
    EXPECT_EQ(html.substr(0, 15), "<!DOCTYPE html>");
    EXPECT_EQ(html.find(">nan"), std::string::npos);
}

TEST_F(Report, WhatWasFittedIsWhatTheMaterialSays) {
    const std::vector<std::string> runs{run("u.h5", recipe("uniaxial", 120e6)), run("t.h5", recipe("triaxial", 160e6, 8e6))};
    expect_texts(page(runs, {.material = read_material("augig-granite")}), {"This material has no [fitted]"});
    std::ifstream file(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml");
    const std::string calibrated = folder_.file("calibrated.toml");
    std::ofstream(calibrated) << file.rdbuf()
                              << "\n[fitted]\nconfined_strength_8MPa = \"193 MPa; 190.123 on 30 new specimens\"\n";
    const std::string html = page(runs, {.material = read_material(calibrated)});
    // As the laboratory calls it, without keys.
    expect_texts(html, {"<td>σ1 at σ3 = 8 MPa</td><td>193 MPa</td><td>190.1\u00a0MPa</td><td>–</td><td>30</td>"});
    EXPECT_EQ(html.find("confined_strength"), std::string::npos);
    EXPECT_TRUE(row_of(html, "σ1 at σ3 = 8 MPa").ends_with("<td>fitted</td>")) << row_of(html, "σ1 at σ3 = 8 MPa");
    EXPECT_TRUE(row_of(html, "UCS").ends_with("<td>predicted</td>")) << row_of(html, "UCS");
}

TEST_F(Report, OfAnotherMaterialSaysSoFirstAndComparesNothing) {
    const std::vector<std::string> runs{run("u.h5", recipe("uniaxial", 120e6))};
    Material gabbro = read_material("augig-granite");
    gabbro.name = "Gabbro";
    EXPECT_NE(page(runs, {gabbro}).find("<th>laboratory"), std::string::npos) << "the same values by another name";
    EXPECT_EQ(diagnostics_.str(), "");
    gabbro.rock.density = 2900;
    const std::string words =
        "the runs are of another material than the one given: they differ from it in material (Augig granite, Gabbro)";
    const std::string html = page(runs, {gabbro});
    EXPECT_TRUE(diagnostics_.str().starts_with("report: " + words)) << diagnostics_.str();
    expect_texts(html, {words});
    EXPECT_EQ(html.find("<th>laboratory"), std::string::npos);
    Material other = read_material("augig-granite");
    other.contact.cohesion = 80e6;
    (void)page(runs, {other});
    EXPECT_NE(diagnostics_.str().find("contact cohesion (74.57 MPa, 80 MPa)"), std::string::npos) << diagnostics_.str();
}

TEST_F(Report, BeginsWithACurveCracksAndTheEnvelopeIfThereIsOne) {
    const std::vector<std::string> runs{run("b.h5", recipe("brazilian", 9e6)), run("u.h5", recipe("uniaxial", 120e6)),
                                        run("u2.h5", recipe("uniaxial", 130e6)), run("t.h5", recipe("triaxial", 160e6, 8e6))};
    const std::string whole = page(runs);
    const std::string three = whole.substr(0, whole.find("<h2"));
    expect_texts(three, {"class=\"first of3\"", "stress and strain of the first run of each kind",
                         "<figure class=\"map\" data-run=\"1\"", "Mohr circles"});
    const std::string unconfined = page({runs[0], runs[1]});
    const std::string two = unconfined.substr(0, unconfined.find("<h2"));
    expect_texts(two, {"class=\"first of2\""});
    EXPECT_EQ(two.find("Mohr circles"), std::string::npos);
}

TEST_F(Report, MineralsStandByPhaseAndClass) {
    test::Recipe r = recipe("uniaxial", 120e6);
    EXPECT_EQ(page({run("one.h5", r)}).find("id=\"minerals\""), std::string::npos);
    r.specimen.phase_names = {"quartz", "mica"};
    for (std::size_t g = 0; g < r.specimen.n_grains(); ++g) r.specimen.grain_phase[g] = g % 4 == 0 ? 1 : 0;
    Material material = read_material("augig-granite");
    material.fabric.phases["quartz"].fraction = 0.745;
    material.fabric.phases["mica"].fraction = 0.255;
    const std::string html = page({run("two.h5", r)}, {.material = material});
    expect_texts(html, {"id=\"minerals\"", "<td>quartz</td><td>74.5</td><td>75</td><td>192</td><td>25.8</td><td>0.23</td>",
                        "<td>all, Reuss to Voigt</td>", "<h3>Contacts and micro-cracks by class</h3>", "<td>quartz–mica</td>",
                        "<th>parameter</th><th>value</th>"});
}

TEST_F(Report, ManyRunsShareAColumnOfChecksWithTheirRange) {
    std::vector<std::string> runs;
    for (int i = 0; i < 5; ++i) runs.push_back(run("b" + std::to_string(i) + ".h5", recipe("brazilian", (9 + i) * 1e6)));
    std::vector<Crack> few = test::synthetic_cracks(test::Recipe{}.specimen);
    few.resize(8);
    test::write_run(runs.back(), recipe("brazilian", 13e6), few);
    const std::string html = page(runs);
    // The energy balance residual is the same in all, separated contacts are half of the cracks; a warning names its run.
    expect_texts(html, {"<th>Brazilian (5 runs)</th></tr>", "<td>0.2\u00a0%</td></tr>", "<td>2 to ",
                        "open cracks never span 0.8 D (5 of 5 runs)",
                        "Caveats of these strengths: ", "Brazilian: open cracks never span 0.8 D (5 of 5 runs)"});
    EXPECT_EQ(html.find("<th>b4</th>"), std::string::npos);
    runs.resize(2);
    expect_texts(page(runs), {"<th>Brazilian (2 runs)</th>"});
}

TEST_F(Report, GrainSizesHaveRowsAndColumnsOfTheirOwnAndWhatIsTheSameStandsOnce) {
    test::Recipe coarse = recipe("uniaxial", 150e6);
    coarse.specimen = test::grid_specimen(4, 8, 0.08, 0.16);
    const std::string html = page(
        {run("fine.h5", recipe("uniaxial", 120e6)), run("coarse.h5", coarse), run("fine4.h5", recipe("triaxial", 160e6, 4e6))});
    const std::string fine = "uniaxial, grain diameter 8 mm", twice = "uniaxial, grain diameter 16 mm";  // half squares
    expect_texts(
        html, {"<td>" + fine + "</td>", "<td>" + twice + "</td>", "<th>" + fine + "</th><th>" + twice + "</th>",
               "<td>UCS, grain diameter 8 mm", "(not resolved: below one edge)</td>", "<td>contact law</td><td colspan=\"3\">"});
    for (const char* kind : {"0", "1", "2"}) {  // a map for each
        expect_texts(html, {fmt::format("<figure class=\"map\" data-run=\"{}\" data-frame=\"", kind)});
    }
    EXPECT_EQ(html.find("data-run=\"3\""), std::string::npos);
}

TEST_F(Report, OneTestHasNoEnvelopeAndSaysWhy) {
    const std::string html = page({run("u.h5", recipe("uniaxial", 120e6))});
    expect_texts(html, {"<h1>Uniaxial compression, Augig granite</h1>", "No envelope: ", "one confining pressure"});
}

TEST_F(Report, RunsWithoutAPeakAreNamedSo) {
    test::Recipe at_strain_limit = recipe("uniaxial", 120e6);
    at_strain_limit.drop = 0;
    at_strain_limit.stop_reason = "strain limit";
    expect_texts(page({run("u.h5", at_strain_limit)}), {"1 of 1 run did not fail", "<td>cap</td>", "<td>did not fail</td>"});
}

TEST_F(Report, CountsCracksByOneRule) {
    const std::string html = page({run("u.h5", recipe("uniaxial", 120e6))});
    for (const char* rule : {"open : closed", "traction angle", "tensile share of cracks"}) {
        EXPECT_EQ(html.find(rule), std::string::npos) << rule;
    }
    const auto counts = [](const std::string& whole) { return row_of(whole, "tensile : shear cracks at the strength"); };
    const std::string by_sign = page({folder_.file("u.h5")}, {.label = {std::nullopt, CrackModeRule::sign}});
    EXPECT_NE(counts(html), counts(by_sign));
    EXPECT_NE(row_of(html, "what counts as a crack"), row_of(by_sign, "what counts as a crack"));
}

TEST(ReportHtml, TextIsEscapedAndEmptyCellsAreDashes) {
    html::Table table({"a<b"});
    table.row({"x & \"y\""});
    table.row({""});
    test::expect_golden(table.str());
    EXPECT_EQ(html::number(std::nan("")), "");
    EXPECT_EQ(html::number(-0.0), "0");
    EXPECT_EQ(html::number(113.4, 2), "113");
    EXPECT_EQ(html::number(0.01234, 2), "0.012");
}

TEST(ReportHtml, PicturesOfManyShapesArePng) {
    Drawing drawing(40, 30);
    drawing.rectangle({0, 0}, {40, 30}, palette::grain);
    EXPECT_NE(html::figure(drawing, "few").find("data:image/svg+xml;base64,PD94bWw"), std::string::npos);  // "<?xml"
    for (int i = 0; i < 3000; ++i) drawing.rectangle({1, 1}, {2, 2}, palette::tensile);
    const std::string figure = html::figure(drawing, "many");
    EXPECT_NE(figure.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);  // the signature of PNG
    // 4 characters for 3 bytes, padded
    const std::size_t from = figure.find("base64,") + 7;
    EXPECT_EQ(figure.find('"', from) - from, (png_bytes(drawing).size() + 2) / 3 * 4);
}

}  // namespace
}  // namespace graincrack
