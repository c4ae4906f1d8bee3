#include "mesher/elements/divided_polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "mesher/plane/step_length.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

/// Sides of a polygon in pieces of about a size.
std::vector<Point> in_pieces(const std::vector<Point>& corners, double size) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point along = corners[(i + 1) % corners.size()] - corners[i];
        const double n = std::max(1.0, std::round(length(along) / size));
        for (double k = 0; k < n; ++k) points.push_back(corners[i] + k / n * along);
    }
    return points;
}

/// An L whose arms are 1 wide, in pieces of a quarter.
const std::vector<Point> ell = in_pieces({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 0.25);
const double h = std::sqrt(0.75);
const std::vector<Point> hexagon{{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}};

TEST(StepLength, IsThatOfTheTriangle) {
    EXPECT_NEAR(step_length({0, 0}, {2, 0}, {1, std::sqrt(3.0)}), 2 * step_length_over_side, 1e-15);
    EXPECT_NEAR(step_length({0, 0}, {1, std::sqrt(3.0)}, {2, 0}), -2 * step_length_over_side, 1e-15);
    EXPECT_NEAR(step_cost(1), 1, 1e-15);
    // The worse a triangle, the larger its cost, those inside out included.
    for (double share = 1; share > -1; share -= 0.01) EXPECT_GT(step_cost(share - 0.01), step_cost(share));
}

TEST(DividedPolygon, HasTheBoundaryAndNoSlivers) {
    const std::vector<Point> square = in_pieces({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.1);
    for (const auto& [boundary, size, area] : {std::tuple(square, 0.1, 1.0), std::tuple(ell, 0.25, 7.0)}) {
        const DividedPolygon divided = divided_polygon(boundary, size);
        std::vector<Point> points = boundary;
        points.insert(points.end(), divided.inner.begin(), divided.inner.end());
        double sum = 0;
        std::map<Edge, int> uses;
        for (const Triangle& t : divided.triangles) {
            const auto at = [&](std::size_t k) { return points[index(t[k])]; };
            sum += signed_area(at(0), at(1), at(2));
            EXPECT_GT(step_length(at(0), at(1), at(2)), 0.6 * step_length_over_side * size);
            count_sides(t, uses);
        }
        EXPECT_NEAR(sum, area, 1e-12);
        EXPECT_EQ(divided.triangles.size(), boundary.size() - 2 + 2 * divided.inner.size());
        const int n = static_cast<int>(boundary.size());
        for (int i = 0; i < n; ++i) EXPECT_EQ((uses[{i, (i + 1) % n}]), 1);
        EXPECT_EQ(divided_polygon(boundary, size).inner, divided.inner);
    }
    const DividedPolygon divided = divided_polygon(hexagon, 1);
    ASSERT_EQ(divided.inner.size(), 1U);
    EXPECT_LT(length(divided.inner[0]), 0.05);
    EXPECT_EQ(divided.triangles.size(), 6U);
}

TEST(PlacedPoints, KeepTheirDistance) {
    const std::vector<Point> boundary = in_pieces({{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 0.1);
    const std::vector<Point> inner = placed_points(boundary, 0.1);
    // Elements of equilateral triangles have 693 points on the whole area.
    EXPECT_NEAR(static_cast<double>(inner.size()), 600, 100);
    std::vector<Point> all = boundary;
    for (const Point p : inner) {
        for (const Point q : all) EXPECT_GE(length(p - q), 0.0719);
        all.push_back(p);
    }
    // No place is left.
    for (double x = 0.03; x < 3; x += 0.05) {
        for (double y = 0.03; y < 2; y += 0.05) {
            const bool is_near = std::any_of(all.begin(), all.end(), [&](Point p) { return length(p - Point{x, y}) < 0.11; });
            EXPECT_TRUE(is_near) << x << " " << y;
        }
    }
    EXPECT_EQ(placed_points(boundary, 0.1), inner);
}

TEST(PlacedPoints, LieWithinThePolygon) {
    const std::vector<Point> inner = placed_points(ell, 0.25);
    EXPECT_GT(inner.size(), 60U);
    for (const Point p : inner) {
        EXPECT_GT(std::min(p.x, p.y), 0.1);
        EXPECT_LT(std::min(p.x, p.y), 0.9);
    }
    const std::vector<Point> one = placed_points(hexagon, 1);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_LT(length(one[0]), 0.3);
    EXPECT_TRUE(placed_points(hexagon, 2).empty());
}

}  // namespace
}  // namespace graincrack::mesher
