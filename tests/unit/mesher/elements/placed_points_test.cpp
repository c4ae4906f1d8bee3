#include "mesher/elements/divided_polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace graincrack::mesher {
namespace {

/// Sides of a polygon in pieces of about a size.
std::vector<Point> divided(const std::vector<Point>& corners, double size) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point along = corners[(i + 1) % corners.size()] - corners[i];
        const double n = std::max(1.0, std::round(length(along) / size));
        for (double k = 0; k < n; ++k) points.push_back(corners[i] + k / n * along);
    }
    return points;
}

TEST(PlacedPoints, KeepTheirDistance) {
    const std::vector<Point> boundary = divided({{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 0.1);
    const std::vector<Point> inner = placed_points(boundary, 0.1);
    // Elements of equilateral triangles have 693 points on the whole area.
    EXPECT_GT(inner.size(), 500U);
    EXPECT_LT(inner.size(), 700U);
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

TEST(PlacedPoints, LieWithinPolygonsThatAreNotConvex) {
    // An L of two arms of width 1.
    const std::vector<Point> inner = placed_points(divided({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 0.25), 0.25);
    EXPECT_GT(inner.size(), 60U);
    for (const Point p : inner) {
        EXPECT_GT(std::min(p.x, p.y), 0.1);
        EXPECT_TRUE(p.x < 0.9 || p.y < 0.9);
    }
}

TEST(PlacedPoints, SmallPolygonsHaveOneInTheMiddleOrNone) {
    std::vector<Point> hexagon;
    for (int i = 0; i < 6; ++i) hexagon.push_back({std::cos(i * std::acos(0.5)), std::sin(i * std::acos(0.5))});
    const std::vector<Point> one = placed_points(hexagon, 1);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_LT(length(one[0]), 0.3);
    EXPECT_TRUE(placed_points(hexagon, 2).empty());
}

}  // namespace
}  // namespace graincrack::mesher
