// Seeds of grains: points with their triangulation, of which some are fixed on loops and prescribed edges.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"
#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// A side that is a side of triangles and of grains: of a loop, with the region on its left, or along a prescribed edge.
struct Side {
    int from = 0, to = 0;
    int part = -1;       ///< of the boundary; −1 along a prescribed edge
    FlawKind kind = {};  ///< of contacts along a prescribed edge
};

/// A point of a loop where a single triangle could cut off the corner, and its neighbours on the loop.
struct Corner {
    int before = 0, at = 0, after = 0;
};

struct Seeds {
    std::vector<Point> points;  ///< the fixed ones first
    std::size_t n_fixed = 0;
    std::vector<Side> sides;  ///< round each loop, then along the prescribed edges
    std::vector<Corner> corners;
    double loading_arc = 0;           ///< angle that a pole facet subtends at the centre, rad; 0 without a facet
    std::vector<Triangle> triangles;  ///< of relaxed seeds
    std::vector<Edge> edges;          ///< of relaxed seeds, ascending
};

}  // namespace graincrack::mesher
