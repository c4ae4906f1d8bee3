#include "post/picture/drawing.hpp"

#include <gtest/gtest.h>

namespace graincrack {
namespace {

TEST(Drawing, SvgSharesPathsOfOneStyleAndEscapesText) {
    Drawing drawing(100, 50);
    drawing.polygon({{0, 0}, {10, 0}, {0, 10}}, palette::grain);
    drawing.polygon({{20, 0}, {30, 0}, {20, 10}}, palette::grain);
    drawing.line({0, 0}, {5, 5}, 2, palette::tensile);
    drawing.text({{1, 2}, "a < b & c"});
    const std::string svg = to_svg(drawing);
    EXPECT_NE(svg.find("width=\"100\" height=\"50\""), std::string::npos);
    EXPECT_NE(svg.find("M0.00 0.00L10.00 0.00L0.00 10.00ZM20.00"), std::string::npos) << svg;
    EXPECT_NE(svg.find("stroke=\"#e83e1c\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
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
