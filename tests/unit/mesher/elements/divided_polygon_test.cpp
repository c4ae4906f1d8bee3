#include "mesher/elements/divided_polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "mesher/plane/step_length.hpp"

namespace graincrack::mesher {
namespace {

double area_of_triangles(const std::vector<Point>& boundary, const DividedPolygon& divided, double& worst) {
    std::vector<Point> points = boundary;
    points.insert(points.end(), divided.inner.begin(), divided.inner.end());
    double sum = 0;
    worst = INFINITY;
    for (const Triangle& t : divided.triangles) {
        const auto at = [&](std::size_t k) { return points[index(t[k])]; };
        sum += signed_area(at(0), at(1), at(2));
        worst = std::min(worst, step_length(at(0), at(1), at(2)));
    }
    return sum;
}

TEST(StepLength, IsThatOfTheTriangle) {
    EXPECT_NEAR(step_length({0, 0}, {2, 0}, {1, std::sqrt(3.0)}), 2 * step_length_over_side, 1e-15);
    EXPECT_NEAR(step_length({0, 0}, {1, std::sqrt(3.0)}, {2, 0}), -2 * step_length_over_side, 1e-15);
    EXPECT_NEAR(step_cost(1), 1, 1e-15);
    // The worse a triangle, the larger its cost, those inside out included.
    for (double share = 1; share > -1; share -= 0.01) EXPECT_GT(step_cost(share - 0.01), step_cost(share));
}

TEST(DividedPolygon, HasTheBoundaryAndNoSlivers) {
    // Sides of a square in pieces of 0.1; an L whose arms are 1 wide, in pieces of a quarter.
    std::vector<Point> square;
    for (int i = 0; i < 10; ++i) square.push_back({0.1 * i, 0});
    for (int i = 0; i < 10; ++i) square.push_back({1, 0.1 * i});
    for (int i = 10; i > 0; --i) square.push_back({0.1 * i, 1});
    for (int i = 10; i > 0; --i) square.push_back({0, 0.1 * i});
    std::vector<Point> ell;
    for (int i = 0; i < 16; ++i) ell.push_back({0.25 * i, 0});
    for (int i = 0; i < 4; ++i) ell.push_back({4, 0.25 * i});
    for (int i = 16; i > 4; --i) ell.push_back({0.25 * i, 1});
    for (int i = 4; i < 16; ++i) ell.push_back({1, 0.25 * i});
    for (int i = 4; i > 0; --i) ell.push_back({0.25 * i, 4});
    for (int i = 16; i > 0; --i) ell.push_back({0, 0.25 * i});
    for (const auto& [boundary, size, area] : {std::tuple(square, 0.1, 1.0), std::tuple(ell, 0.25, 7.0)}) {
        const DividedPolygon divided = divided_polygon(boundary, size);
        double worst = 0;
        EXPECT_NEAR(area_of_triangles(boundary, divided, worst), area, 1e-12);
        EXPECT_GT(worst, 0.6 * step_length_over_side * size);
        EXPECT_EQ(divided.triangles.size(), boundary.size() - 2 + 2 * divided.inner.size());
        std::map<Edge, int> uses;
        for (const Triangle& t : divided.triangles) {
            for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
        }
        for (std::size_t i = 0; i < boundary.size(); ++i) {
            EXPECT_EQ((uses[{static_cast<int>(i), static_cast<int>((i + 1) % boundary.size())}]), 1);
        }
        EXPECT_EQ(divided_polygon(boundary, size).inner, divided.inner);
    }
}

TEST(DividedPolygon, HexagonsHaveSixTrianglesAroundTheirMiddle) {
    std::vector<Point> hexagon;
    for (int i = 0; i < 6; ++i) hexagon.push_back({std::cos(i * std::acos(0.5)), std::sin(i * std::acos(0.5))});
    const DividedPolygon divided = divided_polygon(hexagon, 1);
    ASSERT_EQ(divided.inner.size(), 1U);
    EXPECT_LT(length(divided.inner[0]), 0.05);
    EXPECT_EQ(divided.triangles.size(), 6U);
}

}  // namespace
}  // namespace graincrack::mesher
