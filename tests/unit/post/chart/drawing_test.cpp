#include "post/chart/drawing.hpp"

#include <gtest/gtest.h>

namespace graincrack {
namespace {

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

}  // namespace
}  // namespace graincrack
