// Corners of polygonal cells move to where triangles in the cells are better.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

/// Moves the points of cells so that the cells have given areas: Newton's method, each step of which is the least that fulfils
/// the linear equations, of which there are fewer than unknowns. Moves are measured over the shortest edge at a point, so that
/// edges stay as long as can be. Points of the boundary move along it, fixed ones do not. A step that would turn a cell inside
/// out is halved; it ends where no step makes the areas better.
///
/// \param cells changed
/// \param n_fixed as of `remove_short_edges`
/// \param areas requested, m², with the sum of those that are
/// \return largest difference of an area that is left, over the requested one
double restore_areas(PlaneCells& cells, std::size_t n_fixed, const std::vector<double>& areas);

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
