// Moves corners of polygonal cells to places with better triangles in the cells.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

/// Moves the points of cells so that the cells have given areas. Each step of Newton's method is the smallest solution of the
/// linear equations, which are fewer than the unknowns. Moves are measured over the shortest edge at a point, which preserves
/// edges. Points of the boundary move along it, fixed points do not move. A step that would invert a cell is halved; the
/// iteration ends when no step improves the areas. Each step solves a sparse linear system in the number of cells.
///
/// \param cells changed
/// \param n_fixed see `remove_short_edges`
/// \param areas requested areas, m², with the sum of the present ones
/// \return largest remaining difference of an area, over the requested one
double restore_areas(PlaneCells& cells, std::size_t n_fixed, const std::vector<double>& areas);

/// Moves corners of cells in several sweeps of decreasing moves, each corner to the best of several places. The best place allows
/// the longest time steps of the triangles between sides and middles of cells, without sharp and, less strictly, nearly straight
/// corners. Areas are restored after each sweep. Points of the boundary and of prescribed edges move along them, fixed points do
/// not move. A sweep after which areas cannot be restored is undone.
///
/// \param cells changed
/// \param n_fixed see `remove_short_edges`
/// \param areas requested areas, m², which are the present ones
/// \return largest remaining difference of an area, over the requested one
double relax_corners(PlaneCells& cells, std::size_t n_fixed, const std::vector<double>& areas);

}  // namespace graincrack::mesher
