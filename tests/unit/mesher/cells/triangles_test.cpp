#include "mesher/cells/triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mesher/seeds/fixed_seeds.hpp"
#include "mesher/seeds/relaxation.hpp"
#include "mesher/seeds/sampling.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"
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

/// Whether a point lies on the part of the boundary of an L with holes.
bool is_on_part(Point p, int part) {
    const double from_square_hole = std::max(std::abs(p.x - 0.015), std::abs(p.y - 0.015)) - 0.005;
    const std::array<bool, 7> is_on{p.y == 0,
                                    p.x == 0.08,
                                    p.y == 0.08,
                                    p.x == 0,
                                    std::abs(length(p - Point{0.06, 0.02}) - 0.008) < 2e-4,
                                    p.x == 0.04 || p.y == 0.04,
                                    std::abs(from_square_hole) < 1e-15};
    return is_on.at(index(part));
}

TEST(DelaunayCells, FillARegionWithHolesAndNothingElse) {
    const Region region = l_with_holes();
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const PlaneCells cells = delaunay_cells_of(region, seed);
        EXPECT_GT(cells.size(), 1000U);
        double sum = 0;
        std::map<Edge, int> directed;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::vector<Point> p = corners_of(cells, c);
            ASSERT_EQ(p.size(), 3U);
            EXPECT_GT(area_of(p), 0);
            sum += area_of(p);
            EXPECT_GT(depth_inside(region, (1.0 / 3) * (p[0] + p[1] + p[2])), 0);
            count_sides(cells.loop(c), directed);
        }
        EXPECT_NEAR(sum / area_of_l, 1, 1e-12) << "seed " << seed;
        // Sides without a cell beyond are those of the boundary, on their loop and with its part.
        std::map<Edge, int> boundary;
        for (const Side& side : cells.sides) boundary[{side.from, side.to}] = side.part;
        std::size_t n_open = 0;
        for (const auto& [side, n] : directed) {
            EXPECT_EQ(n, 1);
            if (directed.contains({side[1], side[0]})) continue;
            ++n_open;
            ASSERT_TRUE(boundary.contains(side));
            const Point middle = midpoint(cells.points[index(side[0])], cells.points[index(side[1])]);
            EXPECT_TRUE(is_on_part(middle, boundary[side])) << boundary[side] << ' ' << middle.x << ' ' << middle.y;
        }
        EXPECT_EQ(n_open, boundary.size());
    }
}

}  // namespace
}  // namespace graincrack::mesher
