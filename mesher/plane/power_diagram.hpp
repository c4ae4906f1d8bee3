// Computes the power diagram (Laguerre cells) of weighted points, the dual of their regular triangulation.
#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// The cell of seed i, where |x − cᵢ|² − wᵢ is the smallest of all seeds, is convex; an empty cell has no sides.
struct PowerDiagram {
    /// The common side of two cells: a segment between two vertices, with the cell of `left` on its left.
    struct Side {
        int left = 0, right = 0, from = 0, to = 0;
    };
    std::vector<Point> vertices;
    std::vector<Side> sides;
};

/// Computes the diagram within a circle around the origin; outside of it cells end somewhere. The cost is O(n log n) for n seeds.
/// \param seeds distinct, within the circle
/// \param weights of the seeds, m²
/// \param reach radius of the circle, m
PowerDiagram power_diagram(std::span<const Point> seeds, std::span<const double> weights, double reach);

}  // namespace graincrack::mesher
