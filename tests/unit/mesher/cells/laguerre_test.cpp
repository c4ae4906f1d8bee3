#include "mesher/cells/laguerre.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>

#include "mesher/cells/short_edges.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

/// Each edge between two cells is used once in each direction, each on the boundary once.
void expect_conforming(const PlaneCells& cells) {
    std::map<Edge, int> uses;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        EXPECT_GE(cells.loop(cell).size(), 3U);
        count_sides(cells.loop(cell), uses);
    }
    std::size_t n_outer = 0;
    for (const auto& [edge, n] : uses) {
        EXPECT_EQ(n, 1);
        EXPECT_TRUE(std::binary_search(cells.edges.begin(), cells.edges.end(), edge_between(edge[0], edge[1])));
        if (!uses.contains({edge[1], edge[0]})) ++n_outer;
    }
    EXPECT_EQ(2 * cells.edges.size(), uses.size() + n_outer);
    EXPECT_EQ(cells.sides.size(), n_outer);
    for (std::size_t i = 0; i < cells.sides.size(); ++i) {
        EXPECT_EQ(cells.sides[i].to, cells.sides[(i + 1) % n_outer].from);
        EXPECT_TRUE(uses.contains({cells.sides[i].from, cells.sides[i].to}));
    }
}

TEST(LaguerreCells, HaveTheAreasAskedFor) {
    const std::vector<Region> regions{rectangle(0.08, 0.16), disc(0.08), half_disc(0.1), disc_with_flats(0.05, 0.3),
                                      polygon({{-2, -1}, {1, -1.5}, {2, 1}, {-1, 1.5}}, {"", "", "", ""})};
    for (const Region& region : regions) {
        for (const std::size_t n : {2U, 7U, 400U}) {
            for (const SizeDistribution distribution : {SizeDistribution::normal, SizeDistribution::lognormal}) {
                for (const double spread : {0.0, 0.2, 0.6}) {
                    const RandomCells m(region, n, spread, distribution, n);
                    const std::vector<double> areas = areas_of(m.made.cells);
                    ASSERT_EQ(areas.size(), n);
                    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(areas[i] / m.requested[i], 1, 1e-6);
                    EXPECT_LE(m.made.largest_error, 1e-6);
                    if (n == 400) {
                        EXPECT_NEAR(diameter_variation(areas), spread, 1e-6);
                    }
                    expect_conforming(m.made.cells);
                }
            }
        }
    }
}

TEST(LaguerreCells, AreCompact) {
    for (const double spread : {0.1, 0.6}) {
        const RandomCells m(rectangle(0.08, 0.16), 1000, spread, SizeDistribution::lognormal, 4);
        const PlaneCells& cells = m.made.cells;
        double sum = 0;  // of perimeter² / (4π area): 1.10 of regular hexagons, 1.27 of squares
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const std::vector<Point> p = corners_of(cells, cell);
            double perimeter = 0;
            for (std::size_t i = 0; i < p.size(); ++i) perimeter += length(p[(i + 1) % p.size()] - p[i]);
            sum += perimeter * perimeter / (4 * std::numbers::pi * m.made.areas[cell]);
        }
        EXPECT_LT(sum / 1000, spread < 0.5 ? 1.19 : 1.32) << spread;
    }
}

TEST(LaguerreCells, LoseTheirShortEdges) {
    for (const Region& region : {rectangle(0.08, 0.16), disc(0.08)}) {
        for (const double spread : {0.1, 0.6}) {
            const RandomCells m(region, 1000, spread, SizeDistribution::normal, 2);
            const PlaneCells& before = m.made.cells;
            PlaneCells cells = before;
            const ShortEdges edges = remove_short_edges(cells, m.outline.size());
            EXPECT_GT(edges.n_removed, 10U);
            EXPECT_EQ(edges.n_left, 0U);
            EXPECT_EQ(before.edges.size() - cells.edges.size(), edges.n_removed);
            EXPECT_EQ(before.points.size() - cells.points.size(), edges.n_removed);
            EXPECT_EQ(cells.size(), 1000U);
            expect_conforming(cells);
            for (std::size_t i = 0; i < m.outline.size(); ++i) EXPECT_EQ(cells.points[i], m.outline.corners[i]);
            const std::vector<double> areas = areas_of(cells);
            EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0) / area(region), 1, 1e-9);
            // Before areas are restored: edges up to 0.3 of the root of the smaller area are removed, which moves their ends by
            // half of that, and may take the more from a cell.
            EXPECT_NEAR(diameter_variation(areas), spread, 0.005 * spread + 0.006);
            for (std::size_t cell = 0; cell < cells.size(); ++cell) EXPECT_GT(areas[cell], 0.5 * m.requested[cell]);
        }
    }
}

}  // namespace
}  // namespace graincrack::mesher
