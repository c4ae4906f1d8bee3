// Cells of a Delaunay tessellation.
#pragma once

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

/// Makes each triangle of relaxed seeds a cell, in the same order.
PlaneCells delaunay_cells(Seeds seeds);

}  // namespace graincrack::mesher
