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

Point at(const PlaneCells& cells, int p) { return cells.points[index(p)]; }

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

}  // namespace
}  // namespace graincrack::mesher
