#include "mesher/seeds/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

/// A triangular lattice of n × n points, turned by an angle.
std::vector<Point> lattice(int n, double angle) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Point p{i + 0.5 * j, std::sqrt(0.75) * j};
            points.push_back({p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)});
        }
    }
    return points;
}

/// Edges of the lattice, without the hull's slivers.
std::vector<Edge> lattice_edges(int n) {
    std::vector<Edge> edges;
    const auto at = [n](int i, int j) { return i * n + j; };
    for (int i = 0; i + 1 < n; ++i) {
        for (int j = 0; j + 1 < n; ++j) {
            edges.push_back({at(i, j), at(i + 1, j)});
            edges.push_back({at(i, j), at(i, j + 1)});
            edges.push_back({at(i, j + 1), at(i + 1, j)});
        }
    }
    return edges;
}

TEST(SixFold, IsTheSameForOppositeDirections) {
    const Point v = six_fold({0.3, 0.1});
    EXPECT_NEAR(length(v), 1, 1e-14);
    EXPECT_NEAR(v.y, std::sin(6 * std::atan2(0.1, 0.3)), 1e-12);
    EXPECT_EQ(six_fold({-0.3, -0.1}), v);
    EXPECT_EQ(six_fold({0, 0}), Point{});
}

TEST(EdgeOrientation, IsOneForALatticeAndZeroForDirectionsThatCancel) {
    for (const double angle : {0.0, 0.3, 1.1}) EXPECT_NEAR(psi6(lattice(6, angle), lattice_edges(6)), 1, 1e-12) << angle;
    const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}};
    const std::vector<Edge> edges{{0, 1}, {0, 2}};  // 0° and 90°: e^0 + e^(i 540°) = 0
    EXPECT_NEAR(psi6(points, edges), 0, 1e-14);
}

TEST(EdgeOrientation, ShowsInPartsWhatTheWholeHides) {
    // Horizontal edges below, vertical ones above: no preferred direction in the whole mesh, but one in every part.
    const Region region = rectangle(2, 4);
    std::vector<Point> points;
    std::vector<Edge> edges;
    for (const double x : {-0.5, 0.5}) {
        for (const double y : {-1.5, -0.5, 0.5, 1.5}) {
            points.push_back({x, y});
            points.push_back(y < 0 ? Point{x + 0.1, y} : Point{x, y + 0.1});
            edges.push_back({static_cast<int>(points.size()) - 2, static_cast<int>(points.size()) - 1});
        }
    }
    EXPECT_NEAR(psi6(points, edges), 0, 1e-12);
    EXPECT_NEAR(largest_psi6_of_parts(region, Partition::blocks, points, edges), 1, 1e-12);
}

TEST(EdgeOrientation, IsUniformInALattice) {
    const auto points = lattice(5, 0.2);
    const auto field = local_orientation(points, neighbours_of(lattice_edges(5), points.size()), 3);
    // the last corner has no edges of its own and takes part by smoothing only
    for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_NEAR(std::atan2(field[i].y, field[i].x), 1.2, 1e-9) << i;
}

}  // namespace
}  // namespace graincrack::mesher
