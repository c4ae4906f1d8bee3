// Divides cells into triangles: polygons by a given size, triangles into similar ones.
#pragma once

#include <functional>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/elements/plane_mesh.hpp"

namespace graincrack::mesher {

/// Divides cells into triangles with sides of about `element_size` (m), times `relative_size` there, if given. Each edge is
/// divided into equal pieces, which both adjacent cells share, and each cell is divided between its pieces (`divided_polygon`).
/// \param bodies each cell, or each triangle, is a body
/// \throws UsageError if more than ten million points are needed
PlaneMesh divided_cells(const PlaneCells& cells, Bodies bodies, double element_size,
                        const std::function<double(Point)>& relative_size = {});

/// Makes each triangular cell a body of n × n triangles.
/// \throws UsageError if a specimen of it would need more than 2³¹ − 1 nodes
PlaneMesh lattice_mesh(PlaneCells cells, int n);

}  // namespace graincrack::mesher
