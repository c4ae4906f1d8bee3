#include "post/chart/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "post/chart/axis.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/font.hpp"
#include "post/chart/map_view.hpp"
#include "post/chart/page.hpp"
#include "post/chart/picture_style.hpp"
#include "post/command_line.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/drawing_shapes.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

using test::lines_of;
using test::texts_of;

constexpr Colour pen{1, 2, 3};

Chart unit_chart(const std::optional<Axis>& right = std::nullopt) {
    return {PictureStyle{}, ChartText{"title", {}}, Axis{"x", 0, 1}, Axis{"y", 0, 1}, {right}};
}

TEST(Chart, WhatLeavesTheFrameIsCutAtIt) {
    Chart chart = unit_chart();
    const std::vector<double> x{-1, 2};
    const std::vector<double> y{-1, 2};
    chart.line(x, y, Stroke{pen, 2});
    chart.line(std::vector<double>{0, 1}, std::vector<double>{0, 1}, Stroke{pen, 2});
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 2U);
    for (std::size_t end : {0U, 1U}) {
        EXPECT_NEAR(lines[0].points[end].x, lines[1].points[end].x, 1e-9);
        EXPECT_NEAR(lines[0].points[end].y, lines[1].points[end].y, 1e-9);
    }
}

TEST(Chart, NothingInterruptsButTheFrameAndNaN) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Chart chart = unit_chart();
    chart.line(std::vector<double>{0, 0.2, 0.4, 0.6, 0.8}, std::vector<double>{0, 0.5, nan, 0.5, 1}, Stroke{pen, 2});
    chart.line(std::vector<double>{0, 0.5, 1}, std::vector<double>{0.5, 2, 0.5}, Stroke{pen, 2});  // out and in again
    EXPECT_EQ(lines_of(chart.finish(), pen).size(), 4U);
}

TEST(Chart, SmallStepsAddUpToTheCurveTheyAre) {
    Chart chart = unit_chart();
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= 20000; ++i) {  // steps of 0.04 pixels
        x.push_back(i / 20000.0);
        y.push_back(x.back() * x.back());
    }
    chart.line(x, y, Stroke{pen, 2});
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_GT(lines[0].points.size(), 1000U);
    EXPECT_LT(lines[0].points.size(), 6000U);
    const double width = lines[0].points.back().x - lines[0].points.front().x;
    Chart straight = unit_chart();
    straight.line(std::vector<double>{0, 1}, std::vector<double>{0, 1}, Stroke{pen, 2});
    const auto whole = lines_of(straight.finish(), pen);
    EXPECT_NEAR(width, whole[0].points[1].x - whole[0].points[0].x, 1e-6);
}

TEST(Chart, CurvesOfASeriesStayApartInGrey) {
    for (std::size_t i = 0; i < 5; ++i) {
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(series_stroke(i).dash, series_stroke(k).dash) << i << " and " << k;
    }
    Chart chart = unit_chart();
    chart.line(std::vector<double>{0, 1}, std::vector<double>{0.5, 0.5}, Stroke{pen, 2, Dash::dashed});
    EXPECT_EQ(lines_of(chart.finish(), pen).at(0).dash, Dash::dashed);
}

TEST(Chart, TicksKeepTheirExponent) {
    const Ticks small = ticks_of({"opening, m", 0, 8e-14}, 5);
    EXPECT_EQ(small.label, "opening, 10⁻¹⁵ m");
    EXPECT_EQ(small.texts, (std::vector<std::string>{"0", "20", "40", "60", "80"}));
    EXPECT_EQ(ticks_of({"stress", 0, 4e7}, 4).label, "stress, 10⁶");
    const Ticks plain = ticks_of({"stress, MPa", -50, 150}, 4);
    EXPECT_EQ(plain.label, "stress, MPa");
    EXPECT_EQ(plain.texts, (std::vector<std::string>{"−50", "0", "50", "100", "150"}));
    EXPECT_EQ(ticks_of({"dose", 1e-7, 1e-4, true}, 4).texts, (std::vector<std::string>{"10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴"}));
}

TEST(Chart, TextsOfTicksDoNotTouch) {
    const Axis axis{"x", 0.00010, 0.00018};
    const double length = 300;
    const Ticks ticks = ticks_along(axis, length, 26, 12);
    ASSERT_GT(ticks.values.size(), 1U);
    for (std::size_t i = 1; i < ticks.values.size(); ++i) {
        const double apart = length * (axis.share(ticks.values[i]) - axis.share(ticks.values[i - 1]));
        EXPECT_GT(apart, (text_width(ticks.texts[i], 26) + text_width(ticks.texts[i - 1], 26)) / 2);
    }
}

TEST(Chart, AHollowMarkerIsAClosedOutlineAboutItsPlace) {
    for (const MarkerShape shape : {MarkerShape::disc, MarkerShape::square, MarkerShape::triangle, MarkerShape::diamond}) {
        Drawing drawing(100, 100);
        draw_marker(drawing, {50, 50}, {pen, shape, 20, true});
        const auto lines = lines_of(drawing, pen);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0].points.front().x, lines[0].points.back().x);
        for (const Pixel& corner : lines[0].points) {
            EXPECT_GT(std::hypot(corner.x - 50, corner.y - 50), 8);
            EXPECT_LT(std::hypot(corner.x - 50, corner.y - 50), 15);
        }
    }
}

TEST(Chart, ALabelStandsOnItsLineWhereNothingElseIs) {
    using Places = std::vector<std::array<double, 2>>;
    const auto place_of = [](const Drawing& page, const std::string& label) {
        for (const Text& text : texts_of(page)) {
            if (text.label == label) return text.at.x;
        }
        return std::nan("");
    };
    Chart chart = unit_chart();
    const Places line{{0.5, 0.5}, {0.999, 0.5}, {0.2, 0.5}, {0.8, 0.5}};
    EXPECT_TRUE(chart.label_line(line, "one", pen, Places{}));
    EXPECT_TRUE(chart.label_line(line, "two", pen, Places{}));  // not over the first, not over the frame
    chart.keep_clear({0.8, 0.5}, 6);
    EXPECT_FALSE(chart.label_line(line, "on a marker", pen, Places{}));
    EXPECT_FALSE(chart.label_line(Places{{0.5, 0.8}}, "on a line", pen, Places{{0.5, 0.8}}));
    EXPECT_TRUE(chart.label_line(Places{{0.5, 0.8}}, "beside it", pen, Places{{0.5, 0.2}}));
    const Drawing page = chart.finish();
    EXPECT_LT(place_of(page, "two"), place_of(page, "one"));
    EXPECT_NEAR(place_of(page, "one"), place_of(page, "beside it"), 1e-9);
    EXPECT_TRUE(std::isnan(place_of(page, "on a marker")));
}

TEST(Chart, NotesStandBelowTheLegend) {
    Chart chart{PictureStyle{}, ChartText{"title", {}, {"what a crack is"}}, Axis{"x", 0, 1}, Axis{"y", 0, 1}};
    chart.legend(Stroke{pen, 2}, "entry");
    chart.add_note("and more");
    const std::string words = chart.finish().words();
    EXPECT_LT(words.find("entry"), words.find("what a crack is")) << words;
    EXPECT_LT(words.find("what a crack is"), words.find("and more")) << words;
}

TEST(Page, LinesBreakWhereTheyAreToldAndHyphensBeforeNumbersAreMinuses) {
    EXPECT_EQ(broken_lines("b = -0.5 [-1, 2]\nmode-i run-1", 20, 1000),
              (std::vector<std::string>{"b = −0.5 [−1, 2]", "mode-i run-1"}));
    EXPECT_EQ(broken_lines("", 20, 1000), std::vector<std::string>{""});
}

TEST(Labels, NamesOfColumnsAndMineralsAreThoseOfPrint) {
    EXPECT_EQ(column_label("phi_deg"), "φ, °");
    EXPECT_EQ(column_label("contact_cohesion_MPa"), "contact cohesion, MPa");
    EXPECT_EQ(column_label("strain_at_peak"), "strain at peak");
    EXPECT_EQ(column_label("phic_over_phi"), "φc over φ");
    EXPECT_EQ(column_label("grain_young_modulus_GPa"), "grain Young's modulus, GPa");
    EXPECT_EQ(column_label("philosophy"), "philosophy");
    EXPECT_EQ(mineral_label("k_feldspar"), "K-feldspar");
    EXPECT_EQ(mineral_label("k_feldspar-mica"), "K-feldspar–mica");
    EXPECT_EQ(mineral_label("dark_mica"), "dark mica");
}

TEST(Palette, MineralsHaveOneColourInEveryPicture) {
    const std::vector<Colour> granite = palette::phases({"k_feldspar", "mica", "quartz"});
    const std::vector<Colour> schist = palette::phases({"quartz", "garnet", "staurolite", "mica"});
    EXPECT_EQ(granite[2], schist[0]);
    EXPECT_EQ(granite[1], schist[3]);
    const std::vector<std::string> many{"a", "mica", "biotite", "c", "quartz"};  // two of one colour, and unknown ones
    const std::vector<Colour> colours = palette::phases(many);
    for (std::size_t i = 0; i < many.size(); ++i) EXPECT_EQ(std::ranges::count(colours, colours[i]), 1) << many[i];
    EXPECT_EQ(palette::phases({"rock"}), std::vector<Colour>{palette::grain});
}

TEST(Chart, TheRightScaleIsItsOwn) {
    Chart chart = unit_chart(Axis{"n", 0, 100});
    chart.line(std::vector<double>{0, 1}, std::vector<double>{50, 50}, Stroke{pen, 2}, "", Chart::Side::right);
    chart.line(std::vector<double>{0, 1}, std::vector<double>{0.5, 0.5}, Stroke{pen, 2});
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_NEAR(lines[0].points[0].y, lines[1].points[0].y, 1e-9);
}

TEST(Chart, LogarithmicScaleSpacesDecadesEvenly) {
    Chart chart{PictureStyle{}, ChartText{}, Axis{"x", 0.1, 10, true}, Axis{"y", 0, 1}};
    chart.line(std::vector<double>{0.1, 1, 10}, std::vector<double>{0, 0.5, 1}, Stroke{pen, 2});
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_EQ(lines[0].points.size(), 3U);
    EXPECT_NEAR(lines[0].points[1].x, (lines[0].points[0].x + lines[0].points[2].x) / 2, 1e-9);
}

TEST(Chart, ALongNameInTheLegendLosesItsMiddle) {
    Chart chart = unit_chart();
    std::string name = "φ-first";
    for (int i = 0; i < 20; ++i) name += "_several°";
    chart.legend(Stroke{pen, 2}, name + "_last.h5: peak");
    int found = 0;
    const Drawing page = chart.finish();
    for (const Text& text : texts_of(page)) {
        if (text.label.find("several") == std::string::npos) continue;
        ++found;
        EXPECT_LE(text.at.x + text_width(text.label, text.size, text.bold), page.width());
        EXPECT_EQ(text.label.find("φ-first_"), 0U) << text.label;
        EXPECT_NE(text.label.find("…"), std::string::npos) << text.label;
        EXPECT_NE(text.label.find("_last.h5:"), std::string::npos) << text.label;
    }
    EXPECT_EQ(found, 1);
}

TEST(Chart, RangesLeaveNaNOut) {
    const auto [low, high] = padded_range(std::vector<double>{1, std::nan(""), 3}, 0.1);
    EXPECT_DOUBLE_EQ(low, 0.8);
    EXPECT_DOUBLE_EQ(high, 3.2);
    EXPECT_EQ(padded_range(std::vector<double>{}, 0.1).second, 1);
    const auto [one_low, one_high] = padded_range(std::vector<double>{5}, 0.1);
    EXPECT_LT(one_low, 5);
    EXPECT_GT(one_high, 5);
}

TEST(Drawing, MarksOfOneKindThatFollowEachOtherAreOneShape) {
    Drawing drawing(100, 50);
    for (double x : {0.0, 20.0, 40.0}) drawing.polygon({{x, 0}, {x + 10, 0}, {x, 10}}, palette::grain);
    drawing.rectangle({0, 0}, {1, 1}, palette::grain);  // other sides
    drawing.line({0, 0}, {5, 5}, 2, palette::tensile);
    drawing.line({5, 5}, {9, 5}, 2, palette::tensile);
    drawing.line({5, 5}, {9, 5}, 3, palette::tensile);
    EXPECT_EQ(drawing.shapes().size(), 4U);
    EXPECT_EQ(drawing.n_marks(), 7U);
    Drawing page(200, 100);
    page.add(drawing, {100, 50});
    EXPECT_EQ(std::get<Polygons>(page.shapes()[0])[2][1].x, 150);
    EXPECT_EQ(std::get<Strokes>(page.shapes()[2]).ends.back().y, 55);
}

TEST(Drawing, TicksAreRoundAndInside) {
    EXPECT_EQ(round_ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    const std::vector<double> ticks = round_ticks(-0.21, 0.62, 8);
    ASSERT_FALSE(ticks.empty());
    EXPECT_GE(ticks.front(), -0.21);
    EXPECT_LE(ticks.back(), 0.62);
    EXPECT_TRUE(round_ticks(1, 1, 5).empty());
}

TEST(PictureStyle, LimitsAreTwoNumbersInTheUnitOfTheAxis) {
    const AxisLimits limits = parse_limits("-0.2, 0.4", "--x-limits");
    EXPECT_DOUBLE_EQ(limits.low, -0.2);
    EXPECT_DOUBLE_EQ(limits.high, 0.4);
    for (const char* wrong : {"0.4", "0,", "a,b", "0,inf", "0,4mm"}) {
        test::expect_one_line<UsageError>([&] { (void)parse_limits(wrong, "--x-limits"); }, {"--x-limits", wrong, "0,0.4 fits"});
    }
    test::expect_one_line<UsageError>([&] { (void)parse_limits("0.4,0.4", "--y-limits"); }, {"--y-limits 0.4,0.4", "below"});
    const Axis strain{"strain, % (lateral left, axial right)", -1, 1};
    EXPECT_EQ(strain.unit(), "%");
    EXPECT_DOUBLE_EQ(strain.limited(limits).high, 0.4);
    test::expect_one_line<UsageError>(
        [&] {
            (void)Axis({"n", 1, 9, true}).limited(parse_limits("0,4", "--y-limits"));
        },
        {"logarithmic", "above 0"});
}

TEST(PictureStyle, LimitsThatShowNothingAreRefused) {
    const auto draw = [](const std::string& limits) {
        PictureStyle style;
        style.x_limits = parse_limits(limits, "--x-limits");
        Chart chart(style, {}, {"x, mm", 0, 1}, {"y", 0, 1});
        chart.line(std::vector<double>{0, 1}, std::vector<double>{0, 1}, Stroke{});
        (void)chart.finish();
    };
    EXPECT_NO_THROW(draw("0.5,3"));
    test::expect_one_line<UsageError>([&] { draw("5,6"); }, {"--x-limits 5,6", "nothing lies there", "0,1"});
}

TEST(PictureStyle, ALabelNamesAFileOfThePicture) {
    PictureStyle style;
    style.labels = {parse_run_label("uniaxial=dry, fast"), parse_run_label("runs/wet.h5=wet = slow")};
    EXPECT_EQ(style.label_of("runs/uniaxial.h5"), "dry, fast");
    EXPECT_EQ(style.label_of("runs/wet.h5"), "wet = slow");
    EXPECT_EQ(style.label_of("other.h5"), "");
    test::expect_one_line<UsageError>(
        [&] {
            style.require_labels_of({"uniaxial.h5", "dry.h5"});
        },
        {"--label runs/wet.h5", "uniaxial.h5, dry.h5"});
    for (const char* wrong : {"uniaxial.h5", "=dry", "uniaxial.h5="}) {
        test::expect_one_line<UsageError>([&] { (void)parse_run_label(wrong); }, {"--label", wrong});
    }
}

TEST(PictureStyle, EveryPictureTakesTheOptions) {
    const test::TemporaryFolder folder;
    const std::string run = folder.file("run.h5");
    test::write_run(run, {});
    const auto svg_of = [&](std::vector<std::string> words) {
        const std::string picture = folder.file("picture.svg");
        words.insert(words.begin(), {"graincrack-post", "plot"});
        words.insert(words.end(), {"-o", picture});
        std::vector<const char*> arguments;
        for (const std::string& word : words) arguments.push_back(word.c_str());
        std::ostringstream out;
        run_command_line(static_cast<int>(arguments.size()), arguments.data(), out);
        return test::read_text(picture);
    };
    for (const char* plot : {"specimen", "curve", "cracks", "rosette", "energy", "thresholds"}) {
        EXPECT_NE(svg_of({plot, run, "--title", "My own words"}).find("My own words"), std::string::npos) << plot;
    }
    EXPECT_NE(svg_of({"cracks", run, "--frame", "first,last", "--title", "My own words"}).find("My own words"),
              std::string::npos);
    EXPECT_NE(svg_of({"law", run, "--title", "My own words"}).find("My own words"), std::string::npos);
    EXPECT_NE(svg_of({"curve", run, "--label", "run.h5=dry"}).find("dry\n"), std::string::npos);
    EXPECT_NE(svg_of({"curve", run, "--x-limits", "-0.1,0.2", "--y-limits", "0,500"}).find("\n500\n"), std::string::npos);
    test::expect_one_line<UsageError>([&] { (void)svg_of({"curve", run, "--label", "wet.h5=wet"}); }, {"wet.h5", "run.h5"});
    test::expect_one_line<UsageError>([&] { (void)svg_of({"energy", run, "--x-limits", "1e6,2e6"}); }, {"--x-limits 1e6,2e6"});
}

TEST(ColourScale, HoldsAllButAHundredthOnEachSideAndIsWhiteAtZero) {
    ColourScale scale{"stress, MPa"};
    std::vector<double> values{-1e9, 1e9, std::nan("")};
    for (int i = -40; i < 160; ++i) values.push_back(i);
    scale.include(values);
    EXPECT_EQ(scale.low, -39);
    EXPECT_EQ(scale.high, 158);
    EXPECT_EQ(scale.of(0), palette::white);
    EXPECT_EQ(scale.of(158), (Colour{0, 40, 90}));
    EXPECT_EQ(scale.of(1e9), scale.of(158));
    EXPECT_GT(scale.of(-39).red, scale.of(-39).blue);  // orange
    Drawing page(1000, 0);
    EXPECT_GT(scale.draw(page, {28, 972}, 100), 150);
    for (const char* word : {"stress, MPa\n", "\n0\n", "\n50\n", "\n150\n"}) {
        EXPECT_NE(page.words().find(word), std::string::npos) << word << page.words();
    }
}

}  // namespace
}  // namespace graincrack
