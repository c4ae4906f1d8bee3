// Triangular cells divided into n × n similar triangles.
#pragma once

#include "mesher/cells/plane_cells.hpp"
#include "mesher/elements/plane_mesh.hpp"

namespace graincrack::mesher {

/// Makes each triangular cell a body of n × n triangles.
/// \throws UsageError if a specimen of it would need more than 2³¹ − 1 nodes
PlaneMesh lattice_mesh(PlaneCells cells, int n);

}  // namespace graincrack::mesher
