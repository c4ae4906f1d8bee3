#include "mesher/seeds/size_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/region/shapes.hpp"
#include "mesher/seeds/fixed_seeds.hpp"

namespace graincrack::mesher {
namespace {

const Region graded_region = rectangle(0.04, 0.06);
constexpr double edge = 1e-3;

/// Calls `visit` at points that fill the region evenly.
template <class Visit>
void for_each_point(const Visit& visit) {
    constexpr int n = 300;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) visit(Point{0.04 * ((i + 0.5) / n - 0.5), 0.06 * ((j + 0.5) / n - 0.5)});
    }
}

TEST(SizeField, IsOneWhereNothingIsAsked) {
    const SizeField size(graded_region, edge, {}, {}, 0);
    EXPECT_TRUE(size.is_uniform());
    EXPECT_EQ(size.at({0.01, 0.02}), 1);
    EXPECT_EQ(size.mean_edge(), 1);
    EXPECT_EQ(size.relative_length({0, 0}, {3, 4}), 5);
    EXPECT_EQ(relative_perimeter(graded_region, size), perimeter(graded_region));
}

TEST(SizeField, IsLinearWhereGradedAndKeepsTheNumberOfGrains) {
    const SizeField size(graded_region, edge, parse_grading("along=y,from=0.5,to=2", "--grade"), {}, 0);
    EXPECT_NEAR(size.at({0, 0.03}) / size.at({0, -0.03}), 4, 1e-9);
    EXPECT_NEAR(size.at({0.01, 0}), (size.at({0, 0.03}) + size.at({0, -0.03})) / 2, 1e-9);
    double grains = 0, n = 0;
    for_each_point([&](Point p) {
        grains += 1 / (size.at(p) * size.at(p));
        n += 1;
    });
    EXPECT_NEAR(grains / n, 1, 0.01);  // quadrature of 240 rows
    // Closed forms: the mean of 1/g over that of 1/g² of g from 0.5 to 2 is ln 4 over 1.5, times the scale 1. The quadrature
    // counts a row of the table too many at one end: 1/240 of the area there.
    EXPECT_NEAR(size.mean_edge(), std::log(4) / 1.5, 0.01);
    EXPECT_NEAR(relative_perimeter(rectangle(0.04, 0.06), size),
                0.04 / size.at({0, -0.03}) + 0.04 / size.at({0, 0.03}) + 2 * 0.06 * std::log(4) / 1.5, 1e-3);
}

TEST(SizeField, ScattersByItsDeviationAndKeepsTheNumberOfGrains) {
    RandomNumbers random(2);
    SizeField size(graded_region, edge, {}, {}, 0.35);
    EXPECT_EQ(size.at({0, 0}), 1) << "not drawn";
    size.draw(bounds(graded_region), random);
    double n = 0, sum = 0, squares = 0, grains = 0;
    for_each_point([&](Point p) {
        const double logarithm = std::log(size.at(p));
        EXPECT_GE(size.at(p), size.smallest());
        EXPECT_LE(size.at(p), size.largest());
        n += 1;
        sum += logarithm;
        squares += logarithm * logarithm;
        grains += 1 / (size.at(p) * size.at(p));
    });
    // Some 1,000 independent patches: 2 % of the deviation.
    EXPECT_NEAR(std::sqrt(squares / n - sum * sum / (n * n)), 0.35, 0.03);
    EXPECT_NEAR(sum / n, 0.35 * 0.35, 0.03);
    EXPECT_NEAR(grains / n, 1, 0.08);
}

}  // namespace
}  // namespace graincrack::mesher
