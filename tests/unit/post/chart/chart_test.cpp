#include "post/chart/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "post/chart/axis.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/font.hpp"
#include "post/chart/map_view.hpp"
#include "post/chart/page.hpp"
#include "post/chart/picture_style.hpp"
#include "share/base/error.hpp"
#include "tests/support/drawing_shapes.hpp"
#include "tests/support/golden_refusals.hpp"

namespace graincrack {
namespace {

using test::lines_of;
using test::texts_of;

constexpr Colour pen{1, 2, 3};

const std::vector<double> unit{0, 1};
Chart unit_chart(const std::optional<Axis>& right = std::nullopt) {
    return {PictureStyle{}, ChartText{"title", {}}, Axis{"x", 0, 1}, Axis{"y", 0, 1}, {right}};
}

TEST(Chart, InterruptsLinesAtTheFrameAndNaNAlone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Chart chart = unit_chart();
    chart.line(std::vector<double>{-1, 2}, std::vector<double>{-1, 2}, Stroke{pen, 2});
    chart.line(unit, unit, Stroke{pen, 2});
    chart.line(std::vector<double>{0, 0.2, 0.4, 0.6, 0.8}, std::vector<double>{0, 0.5, nan, 0.5, 1}, Stroke{pen, 2});
    chart.line(std::vector<double>{0, 0.5, 1}, std::vector<double>{0.5, 2, 0.5}, Stroke{pen, 2});  // out and in again
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 6U);
    for (std::size_t end : {0U, 1U}) {
        EXPECT_NEAR(lines[0].points[end].x, lines[1].points[end].x, 1e-9);
        EXPECT_NEAR(lines[0].points[end].y, lines[1].points[end].y, 1e-9);
    }
}

TEST(Chart, KeepsTheLengthOfACurveOfSmallSteps) {
    Chart chart = unit_chart();
    std::vector<double> x, y;
    for (int i = 0; i <= 20000; ++i) {  // steps of 0.04 pixels
        x.push_back(i / 20000.0);
        y.push_back(x.back() * x.back());
    }
    chart.line(x, y, Stroke{pen, 2});
    chart.line(unit, unit, Stroke{pen, 2});
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_GT(lines[0].points.size(), 1000U);
    EXPECT_LT(lines[0].points.size(), 6000U);
    const auto width = [](const Polyline& line) { return line.points.back().x - line.points.front().x; };
    EXPECT_NEAR(width(lines[0]), width(lines[1]), 1e-6);
}

TEST(Chart, KeepsCurvesOfASeriesApartInGrey) {
    for (std::size_t i = 0; i < 5; ++i) {
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(series_stroke(i).dash, series_stroke(k).dash) << i << " and " << k;
    }
    Chart chart = unit_chart();
    chart.line(unit, std::vector<double>{0.5, 0.5}, Stroke{pen, 2, Dash::dashed});
    EXPECT_EQ(lines_of(chart.finish(), pen).at(0).dash, Dash::dashed);
}

TEST(Ticks, KeepTheirExponent) {
    std::string told;
    for (const Axis& axis :
         {Axis{"opening, m", 0, 8e-14}, Axis{"stress", 0, 4e7}, Axis{"stress, MPa", -50, 150}, Axis{"dose", 1e-7, 1e-4, true}}) {
        const Ticks ticks = ticks_of(axis, 4);
        told += ticks.label + ":";
        for (const std::string& text : ticks.texts) told += " " + text;
        told += "\n";
    }
    test::expect_golden(told);
}

TEST(Ticks, DoNotTouch) {
    const Axis axis{"x", 0.00010, 0.00018};
    const double length = 300;
    const Ticks ticks = ticks_along(axis, length, 26, 12);
    ASSERT_GT(ticks.values.size(), 1U);
    for (std::size_t i = 1; i < ticks.values.size(); ++i) {
        const double apart = length * (axis.share(ticks.values[i]) - axis.share(ticks.values[i - 1]));
        EXPECT_GT(apart, (text_width(ticks.texts[i], 26) + text_width(ticks.texts[i - 1], 26)) / 2);
    }
}

TEST(Marker, IsAClosedOutlineIfItIsHollow) {
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

TEST(Chart, LabelsALineWhereNothingElseIs) {
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
    EXPECT_TRUE(chart.label_line(Places{{0.5, 0.8}}, "beside", pen, Places{{0.5, 0.2}}));
    const Drawing page = chart.finish();
    EXPECT_LT(place_of(page, "two"), place_of(page, "one"));
    EXPECT_NEAR(place_of(page, "one"), place_of(page, "beside"), 1e-9);
    EXPECT_TRUE(std::isnan(place_of(page, "on a marker")));
}

TEST(Chart, HasNotesBelowTheLegend) {
    Chart chart{PictureStyle{}, ChartText{"title", {}, {"what a crack is"}}, Axis{"x", 0, 1}, Axis{"y", 0, 1}};
    chart.legend(Stroke{pen, 2}, "entry");
    chart.add_note("and more");
    test::expect_golden(chart.finish().words());
}

TEST(BrokenLines, BreakWhereTheyAreToldAndHaveMinusesBeforeNumbers) {
    EXPECT_EQ(broken_lines("b = -0.5 [-1, 2]\nmode-i run-1", 20, 1000),
              (std::vector<std::string>{"b = −0.5 [−1, 2]", "mode-i run-1"}));
    EXPECT_EQ(broken_lines("", 20, 1000), std::vector<std::string>{""});
}

TEST(Labels, AreNamesOfColumnsAndMineralsInPrint) {
    std::string labels;
    for (const char* const name :
         {"phi_deg", "contact_cohesion_MPa", "strain_at_peak", "phic_over_phi", "grain_young_modulus_GPa", "philosophy"}) {
        labels += column_label(name) + "\n";
    }
    for (const char* const name : {"k_feldspar", "k_feldspar-mica", "dark_mica"}) labels += mineral_label(name) + "\n";
    test::expect_golden(labels);
}

TEST(Palette, GivesAMineralOneColourInEveryPicture) {
    const std::vector<Colour> granite = palette::phases({"k_feldspar", "mica", "quartz"});
    const std::vector<Colour> schist = palette::phases({"quartz", "garnet", "staurolite", "mica"});
    EXPECT_EQ(granite[2], schist[0]);
    EXPECT_EQ(granite[1], schist[3]);
    const std::vector<std::string> many{"a", "mica", "biotite", "c", "quartz"};  // two of one colour, and unknown ones
    const std::vector<Colour> colours = palette::phases(many);
    for (std::size_t i = 0; i < many.size(); ++i) EXPECT_EQ(std::ranges::count(colours, colours[i]), 1) << many[i];
    EXPECT_EQ(palette::phases({"rock"}), std::vector<Colour>{palette::grain});
}

TEST(Chart, HasARightScaleOfItsOwn) {
    Chart chart = unit_chart(Axis{"n", 0, 100});
    chart.line(unit, std::vector<double>{50, 50}, Stroke{pen, 2}, "", Chart::Side::right);
    chart.line(unit, std::vector<double>{0.5, 0.5}, Stroke{pen, 2});
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_NEAR(lines[0].points[0].y, lines[1].points[0].y, 1e-9);
}

TEST(Chart, SpacesDecadesEvenlyOnALogarithmicScale) {
    Chart chart{PictureStyle{}, ChartText{}, Axis{"x", 0.1, 10, true}, Axis{"y", 0, 1}};
    chart.line(std::vector<double>{0.1, 1, 10}, std::vector<double>{0, 0.5, 1}, Stroke{pen, 2});
    const auto lines = lines_of(chart.finish(), pen);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_EQ(lines[0].points.size(), 3U);
    EXPECT_NEAR(lines[0].points[1].x, (lines[0].points[0].x + lines[0].points[2].x) / 2, 1e-9);
}

TEST(Chart, LeavesOutTheMiddleOfALongNameInTheLegend) {
    Chart chart = unit_chart();
    std::string name = "φ-first";
    for (int i = 0; i < 20; ++i) name += "_several°";
    chart.legend(Stroke{pen, 2}, name + "_last.h5: peak");
    const Drawing page = chart.finish();
    std::string shown;
    for (const Text& text : texts_of(page)) {
        EXPECT_LE(text.at.x + text_width(text.label, text.size, text.bold), page.width());
        if (text.label.find("_last") != std::string::npos) shown += text.label;
    }
    test::expect_golden(shown);
}

TEST(PaddedRange, LeavesOutNaN) {
    const auto [low, high] = padded_range(std::vector<double>{1, std::nan(""), 3}, 0.1);
    EXPECT_DOUBLE_EQ(low, 0.8);
    EXPECT_DOUBLE_EQ(high, 3.2);
    EXPECT_EQ(padded_range(std::vector<double>{}, 0.1).second, 1);
    const auto [one_low, one_high] = padded_range(std::vector<double>{5}, 0.1);
    EXPECT_LT(one_low, 5);
    EXPECT_GT(one_high, 5);
}

TEST(Drawing, JoinsMarksOfOneKindThatFollowEachOther) {
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

TEST(Ticks, AreRoundAndInside) {
    EXPECT_EQ(round_ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    const std::vector<double> ticks = round_ticks(-0.21, 0.62, 8);
    ASSERT_FALSE(ticks.empty());
    EXPECT_GE(ticks.front(), -0.21);
    EXPECT_LE(ticks.back(), 0.62);
    EXPECT_TRUE(round_ticks(1, 1, 5).empty());
}

TEST(PictureStyle, HasLimitsOfTwoNumbersInTheUnitOfTheAxis) {
    const AxisLimits limits = parse_limits("-0.2, 0.4", "--x-limits");
    EXPECT_DOUBLE_EQ(limits.low, -0.2);
    EXPECT_DOUBLE_EQ(limits.high, 0.4);
    const Axis strain{"strain, % (lateral left, axial right)", -1, 1};
    EXPECT_EQ(strain.unit(), "%");
    EXPECT_DOUBLE_EQ(strain.limited(limits).high, 0.4);
    const auto draw = [](const std::string& given) {
        PictureStyle style;
        style.x_limits = parse_limits(given, "--x-limits");
        Chart chart(style, {}, {"x, mm", 0, 1}, {"y", 0, 1});
        chart.line(unit, unit, Stroke{});
        (void)chart.finish();
    };
    EXPECT_NO_THROW(draw("0.5,3"));
    test::GoldenRefusals refused;
    refused.add_each<UsageError>({"0.4", "0,", "a,b", "0,inf", "0,4mm", "0.4,0.4", "5,6"}, draw);
    refused.add<UsageError>("of a logarithm", [] { (void)Axis({"n", 1, 9, true}).limited(parse_limits("0,4", "--y-limits")); });
}

TEST(PictureStyle, LabelsFilesOfThePicture) {
    PictureStyle style;
    style.labels = {parse_run_label("uniaxial=dry, 5 mm/s"), parse_run_label("runs/wet.h5=wet = slow")};
    EXPECT_EQ(style.label_of("runs/uniaxial.h5"), "dry, 5 mm/s");
    EXPECT_EQ(style.label_of("runs/wet.h5"), "wet = slow");
    EXPECT_EQ(style.label_of("other.h5"), "");
    test::GoldenRefusals refused;
    refused.add<UsageError>("another file", [&] { style.require_labels_of({"uniaxial.h5", "dry.h5"}); });
    refused.add_each<UsageError>({"uniaxial.h5", "=dry", "uniaxial.h5="}, parse_run_label);
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
    test::expect_golden(page.words());
}

}  // namespace
}  // namespace graincrack
