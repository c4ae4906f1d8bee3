#include "mesher/plane/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "share/base/error.hpp"

namespace graincrack::mesher {
namespace {

double constrained_area(const std::vector<Point>& p, const std::vector<Triangle>& triangles) {
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
        area += signed_area(p[static_cast<std::size_t>(a)], p[static_cast<std::size_t>(b)], p[static_cast<std::size_t>(c)]);
    }
    return area;
}

std::vector<Edge> loop(int first, int n) {
    std::vector<Edge> sides;
    for (int i = 0; i < n; ++i) sides.push_back({first + i, first + (i + 1) % n});
    return sides;
}

const std::vector<Point> l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(ConstrainedTriangulation, FollowsALoopThatIsNotConvex) {
    const auto triangles = constrained_triangles(l, loop(0, 6));
    EXPECT_EQ(triangles.size(), 4U);
    EXPECT_DOUBLE_EQ(constrained_area(l, triangles), 3);
}

TEST(ConstrainedTriangulation, LeavesHolesOutAndKeepsIslands) {
    std::vector<Point> points{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {2, 2}, {2, 7}, {7, 7}, {7, 2}, {4, 4}, {5, 4}, {5, 5}};
    auto sides = loop(0, 4);
    for (const auto& more : {loop(4, 4), loop(8, 3)}) sides.insert(sides.end(), more.begin(), more.end());
    EXPECT_DOUBLE_EQ(constrained_area(points, constrained_triangles(points, sides)), 81 - 25 + 0.5);
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

TEST(ConstrainedTriangulation, CrossingEdgesAreRefused) {
    const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_THROW(constrained_triangles(square, loop(0, 4), std::vector<Edge>{{0, 2}, {1, 3}}), UsageError);
}

TEST(ConstrainedTriangulation, APointThatIsThereTwiceIsRefused) {
    const std::vector<Point> points{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_THROW(constrained_triangles(points, loop(0, 5), {}), UsageError);
}

TEST(ConstrainedTriangulation, ConvexityIsExact) {
    const std::vector<Point> square{{0, 0}, {0.1, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_TRUE(is_convex(square));
    EXPECT_FALSE(is_convex(l));
    auto dented = square;
    dented[1].y = 1e-300;
    EXPECT_FALSE(is_convex(dented));
}

}  // namespace
}  // namespace graincrack::mesher
