#include "mesher/cells/triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "mesher/region/shapes.hpp"
#include "mesher/seeds/fixed_seeds.hpp"
#include "mesher/seeds/relaxation.hpp"
#include "mesher/seeds/sampling.hpp"
#include "tests/unit/mesher/region/test_regions.hpp"

namespace graincrack::mesher {
namespace {

/// Cells of a region with grain edges of 2.5 mm.
PlaneCells delaunay_cells_of(const Region& region, std::uint64_t seed) {
    constexpr double edge = 2.5e-3;
    RandomNumbers random(seed);
    const DepthGrid depth(region, 0.7 * edge);
    Seeds fixed = fixed_seeds(region, admissible_boundary_count(region, perimeter(region) / edge, false), edge, 0.07, random);
    const auto inner = sample_points(region, depth, 0.77 * edge, 0.7 * edge, random);
    return delaunay_cells(relax_points(depth, std::move(fixed), inner, {edge, 0.1, inner.size()}));
}

Point at(const PlaneCells& cells, int p) { return cells.points[static_cast<std::size_t>(p)]; }

TEST(DelaunayCells, FillARegionWithHolesAndNothingElse) {
    const Region region = l_with_holes();
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const PlaneCells cells = delaunay_cells_of(region, seed);
        EXPECT_GT(cells.size(), 1000U);
        double sum = 0;
        std::map<std::pair<int, int>, int> directed;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const auto loop = cells.loop(c);
            ASSERT_EQ(loop.size(), 3U);
            const double own = signed_area(at(cells, loop[0]), at(cells, loop[1]), at(cells, loop[2]));
            EXPECT_GT(own, 0);
            sum += own;
            EXPECT_GT(depth_inside(region, (1.0 / 3) * (at(cells, loop[0]) + at(cells, loop[1]) + at(cells, loop[2]))), 0);
            for (std::size_t k = 0; k < 3; ++k) ++directed[{loop[k], loop[(k + 1) % 3]}];
        }
        EXPECT_NEAR(sum / area_of_l, 1, 1e-12) << "seed " << seed;
        // Sides without a cell beyond are those of the boundary, on their loop and with its part.
        std::map<std::pair<int, int>, int> boundary;
        for (const Side& side : cells.sides) boundary[{side.from, side.to}] = side.part;
        std::size_t n_open = 0;
        for (const auto& [side, n] : directed) {
            EXPECT_EQ(n, 1);
            if (directed.count({side.second, side.first}) != 0) continue;
            ++n_open;
            ASSERT_EQ(boundary.count(side), 1U);
            const Point middle = midpoint(at(cells, side.first), at(cells, side.second));
            const int part = boundary[side];
            const double x = middle.x;
            const double y = middle.y;
            const bool fits = part == 0   ? y == 0
                              : part == 1 ? x == 0.08
                              : part == 2 ? y == 0.08
                              : part == 3 ? x == 0
                              : part == 4 ? std::abs(length(middle - Point{0.06, 0.02}) - 0.008) < 2e-4
                              : part == 5 ? x == 0.04 || y == 0.04
                                          : std::max(std::abs(x - 0.015), std::abs(y - 0.015)) == 0.005 ||
                                                std::abs(std::max(std::abs(x - 0.015), std::abs(y - 0.015)) - 0.005) < 1e-15;
            EXPECT_TRUE(fits) << part << ' ' << x << ' ' << y;
        }
        EXPECT_EQ(n_open, boundary.size());
    }
}

/// Length of the sides that lie on a straight edge to round-off, and the number of points of the mesh on it.
double covered(const PlaneCells& cells, Point from, Point to) {
    const Point along = unit(to - from);
    const auto is_on = [&](Point p) {
        return std::abs(cross(p - from, along)) < 1e-16 && dot(p - from, along) > -1e-16 && dot(p - to, along) < 1e-16;
    };
    double sum = 0;
    for (const Edge& e : cells.edges) {
        if (is_on(at(cells, e[0])) && is_on(at(cells, e[1]))) sum += length(at(cells, e[1]) - at(cells, e[0]));
    }
    return sum;
}

// Ends inside, ends on the boundary and beyond, one that begins on another, two that cross.
TEST(DelaunayCells, FollowPrescribedEdges) {
    Region region = rectangle(0.08, 0.06);
    const std::vector<std::pair<Point, Point>> edges{{{-0.02, 0.011}, {0.01, 0.011}},   {{-0.03, -0.02}, {0.007, -0.003}},
                                                     {{0.02, -0.05}, {0.03, 0.02}},     {{0.013, -0.01}, {0.035, 0.0123}},
                                                     {{-0.01, 0.011}, {-0.005, 0.026}}, {{-0.04, 0.0}, {-0.03, 0.003}}};
    for (const auto& [from, to] : edges) region.edges.push_back({from, to, ContactKind::pre_existing_crack});
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const PlaneCells cells = delaunay_cells_of(region, seed);
        for (const auto& [from, to] : edges) {
            const auto pieces = clip(region, {from, to});
            ASSERT_EQ(pieces.size(), 1U);
            const Point p = pieces[0].from;
            const Point q = pieces[0].to;
            EXPECT_NEAR(covered(cells, p, q) / length(q - p), 1, 1e-12) << from.x << ", seed " << seed;
            for (const Point end : {p, q}) {
                EXPECT_TRUE(
                    std::any_of(cells.points.begin(), cells.points.end(), [&](Point r) { return length(r - end) < 1e-15; }));
            }
        }
        double prescribed = 0;
        for (const Side& side : cells.sides) {
            if (side.part < 0) prescribed += length(at(cells, side.to) - at(cells, side.from));
            EXPECT_EQ(side.kind, side.part < 0 ? ContactKind::pre_existing_crack : ContactKind::grain_boundary);
        }
        double requested = 0;
        for (const PrescribedEdge& e : region.edges) {
            for (const PrescribedEdge& piece : clip(region, e)) requested += length(piece.to - piece.from);
        }
        EXPECT_NEAR(prescribed, requested, 1e-14);
    }
}

// The piece of the edge is as long as the side of the triangle that it cuts off.
TEST(DelaunayCells, FollowAPrescribedEdgeThatCutsACorner) {
    Region region = rectangle(0.08, 0.06);
    region.edges = {{{0.0379, -0.03}, {0.04, -0.0279}}};
    const PlaneCells cells = delaunay_cells_of(region, 1);
    EXPECT_NEAR(covered(cells, region.edges[0].from, region.edges[0].to), length({0.0021, 0.0021}), 1e-16);
}

}  // namespace
}  // namespace graincrack::mesher
