// Makes cells from lists of points, and cells at random.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/walls.hpp"
#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {

/// Cells with counter-clockwise loops of points.
inline PlaneCells cells_of(std::vector<Point> points, const std::vector<std::vector<int>>& loops, std::vector<Side> sides = {}) {
    PlaneCells cells;
    cells.points = std::move(points);
    for (const auto& loop : loops) {
        cells.corners.insert(cells.corners.end(), loop.begin(), loop.end());
        cells.start.push_back(static_cast<int>(cells.corners.size()));
        for (std::size_t i = 0; i < loop.size(); ++i) cells.edges.push_back(edge_between(loop[i], loop[(i + 1) % loop.size()]));
    }
    std::sort(cells.edges.begin(), cells.edges.end());
    cells.edges.erase(std::unique(cells.edges.begin(), cells.edges.end()), cells.edges.end());
    cells.sides = std::move(sides);
    return cells;
}

/// A square of side 2, divided into a left and a right half.
inline PlaneCells halves_of_square() {
    return cells_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}}, {{0, 4, 5, 3}, {4, 1, 2, 5}},
                    {{0, 4, 0, {}}, {4, 1, 0, {}}, {1, 2, 1, {}}, {2, 5, 2, {}}, {5, 3, 2, {}}, {3, 0, 3, {}}});
}

/// Cells of areas that are drawn at random, about as far apart as triangles of their mean area.
struct RandomCells {
    ConvexOutline outline;
    std::vector<double> requested;  ///< areas, m²
    LaguerreCells made;

    RandomCells(const Region& region, std::size_t n, double spread, SizeDistribution distribution, std::uint64_t seed)
        : outline(walls_of(region, std::sqrt(4 * area(region) / (std::numbers::sqrt3 * static_cast<double>(n)))).hull) {
        RandomNumbers random(seed);
        requested = requested_areas(n, moments(outline.corners).area, spread, distribution, random);
        made = laguerre_cells(outline, requested, random);
    }
};

/// Counts the sides of a loop in their direction.
template <class Loop>
void count_sides(const Loop& loop, std::map<Edge, int>& uses) {
    for (std::size_t i = 0; i < loop.size(); ++i) ++uses[{loop[i], loop[(i + 1) % loop.size()]}];
}

}  // namespace graincrack::mesher
