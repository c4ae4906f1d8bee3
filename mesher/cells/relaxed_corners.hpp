// Corners of polygonal cells move to where triangles in the cells are better.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

/// Moves corners of cells in some sweeps of ever smaller moves, each corner to the best of some places: where the triangles that
/// its sides make with the middles of the cells allow the longest time steps, without sharp corners of cells and, less strictly,
/// without nearly straight ones. Areas are restored after each sweep. Points of the boundary and of prescribed edges move along
/// them, fixed ones do not. A sweep after which areas cannot be restored is undone.
///
/// \param cells changed
/// \param n_fixed as of `remove_short_edges`
/// \param areas requested, m², which are those that are
/// \return largest difference of an area that is left, over the requested one
double relax_corners(PlaneCells& cells, std::size_t n_fixed, const std::vector<double>& areas);

}  // namespace graincrack::mesher
