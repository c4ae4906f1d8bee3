#include "post/chart/pixel_fill.hpp"

#include <gtest/gtest.h>

#include "post/plot/plots.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

/// Area of the rectangles of one colour, without the half pixel by which each overlaps the next row.
double area_of(const Drawing& drawing, Colour colour) {
    double area = 0;
    for (const Drawing::Shape& shape : drawing.shapes()) {
        const auto* polygons = std::get_if<Polygons>(&shape);
        if (polygons == nullptr || !(polygons->fill == colour)) continue;
        for (std::size_t i = 0; i < polygons->size(); ++i) {
            const auto c = (*polygons)[i];
            area += std::abs(c[2].x - c[0].x) * (std::abs(c[2].y - c[0].y) - 0.5);
        }
    }
    return area;
}

constexpr Colour red{200, 0, 0};
constexpr Colour blue{0, 0, 200};

TEST(PixelFill, TrianglesCoverTheirArea) {
    PixelFill fill({10, 20}, {110, 220});
    // A square of 80 by 80 pixels, cut along its diagonal; one triangle turns the other way.
    fill.triangle({15, 30}, {95, 30}, {95, 110}, red);
    fill.triangle({15, 30}, {15, 110}, {95, 110}, blue);
    Drawing drawing(200, 300);
    fill.draw(drawing);
    // The diagonal goes through 80 centres, which belong to the later one.
    EXPECT_DOUBLE_EQ(area_of(drawing, red), 3200 - 40);
    EXPECT_DOUBLE_EQ(area_of(drawing, blue), 3200 + 40);
    EXPECT_EQ(drawing.n_marks(), 2 * 80U - 1);  // a run of each colour a row; the last has no red one
}

TEST(PixelFill, WhatIsOffThePageIsLeftOut) {
    PixelFill fill({0, 0}, {10, 10});
    fill.triangle({-50, -50}, {50, -50}, {0, 100}, red);
    fill.triangle({20, 20}, {30, 20}, {20, 30}, blue);
    Drawing drawing(10, 10);
    fill.draw(drawing);
    EXPECT_DOUBLE_EQ(area_of(drawing, red), 100);
    EXPECT_DOUBLE_EQ(area_of(drawing, blue), 0);
}

TEST(PixelFill, APictureOfManyGrainsIsNoLargerThanItsPage) {
    const Specimen specimen = test::grid_specimen(300, 300, 0.08, 0.08);  // edges of 3 pixels
    const Drawing drawing = draw_specimen(specimen, "run.h5");
    EXPECT_LT(drawing.n_marks(), 4000U);                               // 944 rows, 1,200 edges of the rim, legend and title
    EXPECT_NEAR(area_of(drawing, palette::phase(0)), 944 * 944, 944);  // the page without its margins
    EXPECT_GT(draw_specimen(test::grid_specimen(30, 30, 0.08, 0.08), "run.h5").n_marks(), 1800U);  // each grain and outline
}

}  // namespace
}  // namespace graincrack
