#include "mesher/shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace graincrack::mesher {
namespace {

double polygon_area(const std::vector<Point>& points) {
    double doubled = 0;
    for (std::size_t i = 0; i < points.size(); ++i) doubled += cross(points[i], points[(i + 1) % points.size()]);
    return doubled / 2;
}

bool is_convex(const std::vector<Point>& p) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Point a = p[(i + 1) % p.size()] - p[i];
        const Point b = p[(i + 2) % p.size()] - p[(i + 1) % p.size()];
        if (cross(a, b) < 0) return false;
    }
    return true;
}

const Shape rectangle{ShapeKind::rectangle, 0.08, 0.16, Pole::facet};
const Shape facet_disc{ShapeKind::disc, 0.08, 0.08, Pole::facet};
const Shape vertex_disc{ShapeKind::disc, 0.08, 0.08, Pole::vertex};

TEST(Shape, BoundaryCountHasTheParityAskedFor) {
    EXPECT_EQ(admissible_boundary_count(rectangle, 92.9, false), 92);
    EXPECT_EQ(admissible_boundary_count(rectangle, 92.9, true), 93);
    EXPECT_EQ(admissible_boundary_count(facet_disc, 1.0, false), 4);
    EXPECT_EQ(admissible_boundary_count(facet_disc, 1.0, true), 5);
}

TEST(Shape, RectangleOutlineKeepsCornersSidesAndParts) {
    RandomNumbers random(1);
    const Outline outline = make_outline(rectangle, 92, 0.1, random);
    ASSERT_EQ(outline.points.size(), 92U);
    ASSERT_EQ(outline.corners.size(), 4U);
    EXPECT_EQ(outline.points[static_cast<std::size_t>(outline.corners[2])], (Point{0.04, 0.08}));
    EXPECT_NEAR(polygon_area(outline.points), rectangle.area(), 1e-16);
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const Point middle = midpoint(outline.points[i], outline.points[(i + 1) % outline.points.size()]);
        switch (outline.parts[i]) {  // exactly on its side, as the triangulation requires
            case BoundaryPart::bottom: EXPECT_EQ(middle.y, -0.08); break;
            case BoundaryPart::right: EXPECT_EQ(middle.x, 0.04); break;
            case BoundaryPart::top: EXPECT_EQ(middle.y, 0.08); break;
            case BoundaryPart::left: EXPECT_EQ(middle.x, -0.04); break;
            default: FAIL() << "a rectangle has no rim";
        }
    }
    EXPECT_EQ(std::count(outline.parts.begin(), outline.parts.end(), BoundaryPart::bottom), 15);
    EXPECT_EQ(std::count(outline.parts.begin(), outline.parts.end(), BoundaryPart::right), 31);
}

TEST(Shape, DiscHasTheAreaOfTheCircleAndTouchesThePlatens) {
    for (const Shape& disc : {facet_disc, vertex_disc}) {
        for (const int n : {8, 49, 50, 51, 52}) {
            RandomNumbers random(3);
            const Outline outline = make_outline(disc, n, 0.07, random);
            ASSERT_EQ(outline.points.size(), static_cast<std::size_t>(n));
            EXPECT_TRUE(is_convex(outline.points)) << n;
            EXPECT_NEAR(polygon_area(outline.points) / disc.area(), 1, 1e-13) << n;
            const std::size_t wanted = disc.pole == Pole::facet ? 2 : 1;
            for (const double y : {0.04, -0.04}) {
                const auto touching =
                    std::count_if(outline.points.begin(), outline.points.end(), [&](Point p) { return p.y == y; });
                EXPECT_EQ(static_cast<std::size_t>(touching), wanted) << n;
            }
            for (const Point p : outline.points) EXPECT_LE(std::abs(p.y), 0.04) << n;
            for (const BoundaryPart part : outline.parts) EXPECT_EQ(part, BoundaryPart::rim);
        }
    }
}

TEST(Shape, LoadingArcIsTheAngleOfThePoleFacet) {
    RandomNumbers random(1);
    const Outline facet = make_outline(facet_disc, 50, 0.07, random);
    double left = 0;
    double right = 0;
    for (const Point p : facet.points) {
        if (p.y != 0.04) continue;
        left = std::min(left, p.x);
        right = std::max(right, p.x);
    }
    EXPECT_NEAR(left, -right, 1e-15);
    EXPECT_NEAR(facet.loading_arc, 2 * std::atan2(right, 0.04), 1e-12);
    EXPECT_NEAR(facet.loading_arc, 2 * 3.14159265358979 / 50, 1e-3);
    EXPECT_EQ(make_outline(vertex_disc, 50, 0.07, random).loading_arc, 0);
}

TEST(Shape, DepthIsPositiveInside) {
    EXPECT_DOUBLE_EQ(depth_inside(rectangle, {0.03, 0}), 0.01);
    EXPECT_LT(depth_inside(rectangle, {0, 0.09}), 0);
    EXPECT_DOUBLE_EQ(depth_inside(facet_disc, {0, 0.03}), 0.01);
}

}  // namespace
}  // namespace graincrack::mesher
