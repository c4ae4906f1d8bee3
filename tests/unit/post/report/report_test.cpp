#include "post/report/report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "post/chart/picture.hpp"
#include "post/report/html.hpp"
#include "post/report/test_report.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/page_text.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

class Report : public test::RunFolder {
protected:
    test::Recipe recipe(const std::string& test, double peak, double confining = 0) {
        const PlaneCondition plane = test == "brazilian" ? PlaneCondition::stress : PlaneCondition::strain;
        return {.test = test, .plane = plane, .confining_pressure = confining, .peak = peak};
    }
    std::string page(const std::vector<std::string>& runs, const ReportOptions& options = {}) {
        diagnostics_.str("");
        return make_report(runs, options, Verbosity::quiet, diagnostics_);
    }
    /// The text of some sections.
    static std::string text_of(const std::string& page, const std::vector<std::string>& sections) {
        std::string text;
        for (const std::string& id : sections) text += test::text_of_page(test::section_of(page, id));
        return text;
    }
    /// Each attribute points into the page or carries its data.
    static void expect_own_references(const std::string& page, const std::string& attribute) {
        for (std::size_t i = page.find(attribute); i != std::string::npos; i = page.find(attribute, i + 1)) {
            const std::string value = page.substr(i + attribute.size(), 60);
            EXPECT_TRUE(value.starts_with("data:") || value.starts_with('#')) << value;
        }
    }
    std::ostringstream diagnostics_;
};

TEST(Figures, LeaveNoColumnEmpty) {
    const auto places = [](const std::string& html) {
        std::string found;
        for (std::size_t at = html.find("<figure"); at != std::string::npos; at = html.find("<figure", at + 1)) {
            found += html.substr(at, html.find('>', at) + 1 - at);
        }
        return found;
    };
    html::Figures charts, maps;
    std::vector<double> widths;
    const std::string across = "<figure class=\"across\">", middle = "<figure class=\"middle\">", column = "<figure>";
    for (const std::string& expected : {across, column + column, across + column + column}) {
        charts.add("chart", [&](const PictureStyle& style) {
            widths.push_back(style.page_width);
            return Drawing(10, 10);
        });
        widths.clear();
        EXPECT_EQ(places(charts.str()), expected);
        EXPECT_EQ(widths.front(), html::figure_style(expected.starts_with(across)).page_width);
        EXPECT_EQ(widths.back(), html::figure_style(expected == across).page_width);
    }
    for (const std::string& expected : {middle, column + column}) {
        maps.add_specimen("specimen", [](const PictureStyle&) { return Drawing(10, 10); });
        EXPECT_EQ(places(maps.str()), expected);
    }
}

TEST_F(Report, HasAllSectionsOfASetAndNothingFromElsewhere) {
    const std::string html = page({run("u.h5", recipe("uniaxial", 120e6)), run("t.h5", recipe("triaxial", 160e6, 4e6)),
                                   run("b.h5", recipe("brazilian", 9e6))},
                                  {.material = read_material("augig-granite")});
    // Namespaces of SVG are names, not addresses that are fetched.
    expect_own_references(html, "src=\"");
    expect_own_references(html, "href=\"");
    EXPECT_EQ(html.find("@import"), std::string::npos);
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
    EXPECT_NE(test::section_of(html, "provenance"), "");
    // Laboratory: σt 8.8, UCS 122 MPa with the usual deviation of 5 %; σ1 at 4 MPa on the line UCS + b σ3, b = 8.93.
    test::expect_golden(text_of(html, {"laboratory", "means", "curves", "quality-checks", "envelope", "maps", "mesh", "inputs"}));
}

TEST_F(Report, HasWhatWasFittedAsTheMaterialSays) {
    const std::vector<std::string> runs{run("u.h5", recipe("uniaxial", 120e6)), run("t.h5", recipe("triaxial", 160e6, 8e6))};
    Material material = read_material("augig-granite");
    material.fitted = {{"confined_strength_8MPa", "193 MPa; 190.123 on 30 new specimens"}};
    test::expect_golden(text_of(page(runs, {.material = material}), {"laboratory"}));
}

TEST_F(Report, ComparesNothingWithAnotherMaterialAndSaysSoFirst) {
    const std::vector<std::string> runs{run("u.h5", recipe("uniaxial", 120e6))};
    Material gabbro = read_material("augig-granite");
    const std::string same = text_of(page(runs, {gabbro}), {"laboratory"});
    gabbro.name = "Gabbro";
    EXPECT_EQ(text_of(page(runs, {gabbro}), {"laboratory"}), same) << "the same values by another name";
    EXPECT_EQ(diagnostics_.str(), "");
    gabbro.rock.density = 2900;
    const std::string html = page(runs, {gabbro});
    test::expect_golden(diagnostics_.str() + test::text_of_page(html.substr(0, html.find("<h2"))));
    test::expect_golden(text_of(html, {"laboratory"}), "properties");
    gabbro = read_material("augig-granite");
    gabbro.contact.cohesion = 80e6;
    (void)page(runs, {gabbro});
    test::expect_golden(diagnostics_.str(), "another cohesion");
}

TEST_F(Report, BeginsWithACurveCracksAndTheEnvelopeIfThereIsOne) {
    const std::vector<std::string> runs{run("b.h5", recipe("brazilian", 9e6)), run("u.h5", recipe("uniaxial", 120e6)),
                                        run("u2.h5", recipe("uniaxial", 130e6)), run("t.h5", recipe("triaxial", 160e6, 8e6))};
    const std::string three = page(runs), two = page({runs[0], runs[1]});
    EXPECT_NE(three.find("class=\"first of3\""), std::string::npos);
    EXPECT_NE(three.substr(0, three.find("<h2")).find("<figure class=\"map\" data-run=\"1\""), std::string::npos);
    EXPECT_NE(two.find("class=\"first of2\""), std::string::npos);
    test::expect_golden(test::text_of_page(three.substr(0, three.find("<h2"))), "three kinds");
    test::expect_golden(test::text_of_page(two.substr(0, two.find("<h2"))), "two kinds");
}

TEST_F(Report, HasMineralsByPhaseAndClass) {
    test::Recipe r = recipe("uniaxial", 120e6);
    EXPECT_EQ(test::section_of(page({run("one.h5", r)}), "minerals"), "");
    r.specimen.phase_names = {"quartz", "mica"};
    for (std::size_t g = 0; g < r.specimen.n_grains(); ++g) r.specimen.grain_phase[g] = g % 4 == 0 ? 1 : 0;
    Material material = read_material("augig-granite");
    material.fabric.phases["quartz"].fraction = 0.745;
    material.fabric.phases["mica"].fraction = 0.255;
    test::expect_golden(text_of(page({run("two.h5", r)}, {.material = material}), {"minerals"}));
}

TEST_F(Report, SharesAColumnOfChecksAmongManyRunsWithTheirRange) {
    std::vector<std::string> runs;
    for (int i = 0; i < 5; ++i) runs.push_back(run("b" + std::to_string(i) + ".h5", recipe("brazilian", (9 + i) * 1e6)));
    std::vector<Crack> few = test::synthetic_cracks(test::Recipe{}.specimen);
    few.resize(8);
    test::write_run(runs.back(), recipe("brazilian", 13e6), few);
    test::expect_golden(text_of(page(runs), {"means", "quality-checks"}));
    runs.resize(2);
    test::expect_golden(text_of(page(runs), {"quality-checks"}), "two runs");
}

TEST_F(Report, HasRowsAndColumnsForEachGrainSize) {
    test::Recipe coarse = recipe("uniaxial", 150e6);
    coarse.specimen = test::grid_specimen(4, 8, 0.08, 0.16);
    const std::string html = page(
        {run("fine.h5", recipe("uniaxial", 120e6)), run("coarse.h5", coarse), run("fine4.h5", recipe("triaxial", 160e6, 4e6))});
    test::expect_golden(text_of(html, {"laboratory", "means", "quality-checks", "mesh"}));
    for (const char* run : {"0", "1", "2", "3"}) {  // a map for each
        const bool is_drawn = html.find(fmt::format("<figure class=\"map\" data-run=\"{}\"", run)) != std::string::npos;
        EXPECT_EQ(is_drawn, std::string(run) != "3") << run;
    }
}

TEST_F(Report, SaysWhyItHasNoEnvelopeAndWhichRunsHaveNoPeak) {
    test::expect_golden(text_of(page({run("u.h5", recipe("uniaxial", 120e6))}), {"envelope"}));
    test::expect_golden(text_of(page({run("u.h5", {.peak = 120e6, .drop = 0, .stop_reason = "strain limit"})}),
                                {"means", "quality-checks", "envelope"}),
                        "no peak");
}

TEST_F(Report, CountsCracksByOneRule) {
    const std::vector<std::string> runs{run("u.h5", recipe("uniaxial", 120e6))};
    test::expect_golden(text_of(page(runs), {"quality-checks"}));
    test::expect_golden(text_of(page(runs, {.label = {std::nullopt, CrackModeRule::sign}}), {"quality-checks"}), "by sign");
}

TEST(ReportHtml, EscapesTextAndHasDashesInEmptyCells) {
    html::Table table({"a<b"});
    table.row({"x & \"y\""});
    table.row({""});
    test::expect_golden(table.str());
    EXPECT_EQ(html::number(std::nan("")), "");
    EXPECT_EQ(html::number(-0.0), "0");
    EXPECT_EQ(html::number(113.4, 2), "113");
    EXPECT_EQ(html::number(0.01234, 2), "0.012");
}

TEST(ReportHtml, HasPicturesOfManyShapesAsPng) {
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
