#include "mesher/plane/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesher/plane/random_numbers.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {
namespace {

std::vector<Point> random_points(std::size_t n, std::uint64_t seed) {
    RandomNumbers random(seed);
    std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    while (points.size() < n) points.push_back({0.01 + 0.98 * random.uniform(), 0.01 + 0.98 * random.uniform()});
    return points;
}

std::vector<Triangle> delaunay_triangles(const std::vector<Point>& points) {
    DelaunayMesh mesh;
    mesh.build(points);
    return mesh.triangles();
}

/// Triangles in a form independent of their order.
std::set<Triangle> as_set(const std::vector<Triangle>& triangles) {
    std::set<Triangle> result;
    for (Triangle t : triangles) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        result.insert(t);
    }
    return result;
}

double total_area(const std::vector<Point>& p, const std::vector<Triangle>& triangles) {
    double area = 0;
    for (const Triangle& t : triangles) {
        const double a = signed_area(p[index(t[0])], p[index(t[1])], p[index(t[2])]);
        EXPECT_GT(a, 0);
        area += a;
    }
    return area;
}

TEST(Triangulation, CoversTheHullAndObeysEuler) {
    const auto points = random_points(500, 1);
    const auto triangles = delaunay_triangles(points);
    EXPECT_EQ(triangles.size(), 2 * 496 + 4 - 2U);
    EXPECT_NEAR(total_area(points, triangles), 1, 1e-12);
    EXPECT_EQ(edges_of(triangles, points.size()).size(), (3 * triangles.size() + 4) / 2);
}

TEST(Triangulation, IsDelaunay) {
    const auto points = random_points(60, 2);
    for (const Triangle& t : delaunay_triangles(points)) {
        const Point a = points[index(t[0])];
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point p = points[index(t[1])] - a;
            const Point q = points[index(t[2])] - a;
            const Point r = points[i] - a;
            // determinant of the incircle test, positive inside
            const double inside =
                cross(p, q) * squared_length(r) - cross(p, r) * squared_length(q) + cross(q, r) * squared_length(p);
            EXPECT_GE(inside, -1e-12) << i;
        }
    }
}

TEST(Triangulation, EndsForPointsOnOneCircle) {
    std::vector<Point> points;
    for (int i = 0; i < 400; ++i) points.push_back({std::cos(i * 3.14159265358979 / 200), std::sin(i * 3.14159265358979 / 200)});
    EXPECT_EQ(delaunay_triangles(points).size(), 398U);
    points.push_back({0, 0});
    EXPECT_EQ(delaunay_triangles(points).size(), 400U);
}

TEST(Triangulation, IsTheSameOfMovedAndOfNewPoints) {
    auto points = random_points(800, 3);
    DelaunayMesh mesh;
    mesh.build(points);
    RandomNumbers random(4);
    for (const double reach : {0.001, 0.003, 0.2}) {  // the last one inverts triangles
        for (std::size_t i = 4; i < points.size(); ++i) {
            points[i].x = std::clamp(points[i].x + reach * random.symmetric(), 0.005, 0.995);
            points[i].y = std::clamp(points[i].y + reach * random.symmetric(), 0.005, 0.995);
        }
        mesh.move(points);
        EXPECT_EQ(as_set(mesh.triangles()), as_set(delaunay_triangles(points))) << reach;
    }
}

TEST(Triangulation, HasUniqueAscendingEdges) {
    const std::vector<Triangle> two{{0, 1, 2}, {2, 1, 3}};
    EXPECT_EQ(edges_of(two, 4), (std::vector<Edge>{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}));
}

TEST(CornerEar, IsSplitAlongTheOtherDiagonalUnlessThatIsFlat) {
    std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {0.8, 0.8}};
    const std::vector<Triangle> ear{{0, 1, 2}, {1, 3, 2}};
    std::vector<Triangle> triangles = ear;
    EXPECT_TRUE(split_corner_ear(points, triangles, 0, 2, 1));
    EXPECT_EQ(as_set(triangles), (std::set<Triangle>{{0, 1, 3}, {0, 3, 2}}));
    EXPECT_FALSE(split_corner_ear(points, triangles, 0, 2, 1)) << "there is no ear any more";
    points[3] = {2, 0};
    triangles = ear;
    EXPECT_FALSE(split_corner_ear(points, triangles, 0, 2, 1));
    EXPECT_EQ(triangles, ear);
}

TEST(HilbertOrder, VisitsNeighboursInTurn) {
    std::vector<Point> points;
    for (int i = 0; i < 16; ++i) {
        for (int j = 0; j < 16; ++j) points.push_back({static_cast<double>(i), static_cast<double>(j)});
    }
    const auto order = hilbert_order(points);
    ASSERT_EQ(std::set<int>(order.begin(), order.end()).size(), 256U);
    for (std::size_t k = 1; k < order.size(); ++k) {
        const Point step = points[static_cast<std::size_t>(order[k])] - points[static_cast<std::size_t>(order[k - 1])];
        EXPECT_EQ(std::abs(step.x) + std::abs(step.y), 1) << k;
    }
}

std::vector<Edge> loop(int first, int n) {
    std::vector<Edge> sides;
    for (int i = 0; i < n; ++i) sides.push_back({first + i, first + (i + 1) % n});
    return sides;
}

const std::vector<Point> l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(ConstrainedTriangulation, FollowsLoopsAroundHolesAndIslands) {
    const auto triangles = constrained_triangles(l, loop(0, 6));
    EXPECT_EQ(triangles.size(), 4U);
    EXPECT_DOUBLE_EQ(total_area(l, triangles), 3);
    const std::vector<Point> points{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {2, 2}, {2, 7}, {7, 7}, {7, 2}, {4, 4}, {5, 4}, {5, 5}};
    auto sides = loop(0, 4);
    for (const auto& more : {loop(4, 4), loop(8, 3)}) sides.insert(sides.end(), more.begin(), more.end());
    EXPECT_DOUBLE_EQ(total_area(points, constrained_triangles(points, sides)), 81 - 25 + 0.5);
}

TEST(ConstrainedTriangulation, HasThePrescribedEdges) {
    // Delaunay would take the shorter diagonal.
    const std::vector<Point> kite{{-5, 0}, {0, -1}, {5, 0}, {0, 1}};
    const auto has_long_diagonal = [](const std::vector<Triangle>& triangles) {
        const auto edges = edges_of(triangles, 4);
        return std::find(edges.begin(), edges.end(), Edge{0, 2}) != edges.end();
    };
    EXPECT_FALSE(has_long_diagonal(constrained_triangles(kite, loop(0, 4))));
    EXPECT_TRUE(has_long_diagonal(constrained_triangles(kite, loop(0, 4), std::vector<Edge>{{0, 2}})));
}

TEST(ConstrainedTriangulation, RefusesCrossingEdgesAndDoublePoints) {
    const std::vector<Point> unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_THROW(constrained_triangles(unit_square, loop(0, 4), std::vector<Edge>{{0, 2}, {1, 3}}), UsageError);
    const std::vector<Point> points{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_THROW(constrained_triangles(points, loop(0, 5), {}), UsageError);
}

TEST(Convexity, IsExact) {
    const std::vector<Point> unit_square{{0, 0}, {0.1, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_TRUE(is_convex(unit_square));
    EXPECT_FALSE(is_convex(l));
    auto dented = unit_square;
    dented[1].y = 1e-300;
    EXPECT_FALSE(is_convex(dented));
}

}  // namespace
}  // namespace graincrack::mesher
