// Removes short edges of polygonal cells, which would cause small elements and short time steps.
#pragma once

#include <cstddef>

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

/// Length, over the root of the area of the smaller adjacent cell, below which an edge is short. Chosen by trial.
inline constexpr double short_edge = 0.30;
/// The same length for cells that have little room to restore their areas. Chosen by trial.
inline constexpr double very_short_edge = 0.125;

struct ShortEdges {
    std::size_t n_removed = 0;
    std::size_t n_left = 0;  ///< edges whose removal would leave a cell with two sides, invert one, or move a fixed point
};

/// Removes short edges, the shortest first, in at most two rounds: the ends of an edge become one point in its middle. Points of
/// the boundary stay on it, and fixed points do not move.
/// \param cells convex before; changed
/// \param n_fixed number of fixed points, which come first; sides are straight on the boundary between two of them
/// \param short_below `short_edge` or another such length
ShortEdges remove_short_edges(PlaneCells& cells, std::size_t n_fixed, double short_below = short_edge);

}  // namespace graincrack::mesher
