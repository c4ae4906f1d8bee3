// Seeds of grains: points with their triangulation. Some are fixed on loops and prescribed edges.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"
#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// A common side of triangles and grains: on a loop, with the region on its left, or along a prescribed edge.
struct Side {
    int from = 0, to = 0;
    int part = -1;       ///< boundary part; −1 along a prescribed edge
    FlawKind kind = {};  ///< kind of contacts along a prescribed edge
};

/// A corner of a loop that a single triangle could cut off, and its neighbours on the loop.
struct Corner {
    int before = 0, at = 0, after = 0;
};

struct Seeds {
    std::vector<Point> points;  ///< points, the fixed ones first
    std::size_t n_fixed = 0;
    std::vector<Side> sides;  ///< sides around each loop, then along the prescribed edges
    std::vector<Corner> corners;
    double loading_arc = 0;           ///< angle of a pole facet seen from the centre, rad; 0 without a facet
    std::vector<Triangle> triangles;  ///< filled for relaxed seeds
    std::vector<Edge> edges;          ///< filled for relaxed seeds, ascending
};

}  // namespace graincrack::mesher
