// Short edges of polygonal cells, which would make small elements and short time steps, are removed.
#pragma once

#include <cstddef>

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

/// Length below which an edge is short, over the square root of the area of the smaller cell beside it.
inline constexpr double short_edge = 0.30;
/// The same of cells that have little room to restore their areas.
inline constexpr double very_short_edge = 0.125;

struct ShortEdges {
    std::size_t n_removed = 0;
    std::size_t n_left = 0;  ///< whose removal would leave a cell of two sides or turn one inside out, or move what is fixed
};

/// Removes short edges, the shortest first, in at most two rounds: the ends of an edge become one point in its middle. On the
/// boundary they stay on it, and fixed points do not move.
/// \param cells convex before; changed
/// \param n_fixed the first so many points are fixed; on the boundary between two of them the cells' sides are straight
/// \param short_below `short_edge` or another such length
ShortEdges remove_short_edges(PlaneCells& cells, std::size_t n_fixed, double short_below = short_edge);

}  // namespace graincrack::mesher
