// Polygonal cells divided into triangles of a given size.
#pragma once

#include <functional>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/elements/plane_mesh.hpp"

namespace graincrack::mesher {

/// Divides cells into triangles with sides of about `element_size`, times `relative_size` there, if given. Each edge of the cells
/// is divided evenly, into pieces that both of its cells have, and each cell is divided between its pieces (`divided_polygon`).
/// \param bodies whether each cell is a body, or each triangle
/// \throws UsageError if more than ten million points are needed
PlaneMesh divided_cells(const PlaneCells& cells, Bodies bodies, double element_size,
                        const std::function<double(Point)>& relative_size = {});

}  // namespace graincrack::mesher
