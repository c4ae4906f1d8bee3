// Polygonal cells divided into triangles between their corners.
#pragma once

#include "mesher/cells/plane_cells.hpp"
#include "mesher/elements/plane_mesh.hpp"

namespace graincrack::mesher {

/// What becomes a body: each cell, or each triangle of it, so that crystals can break.
enum class Bodies { cells, triangles };

/// Makes the constrained Delaunay triangles of each cell, which need not be convex; no point is added.
PlaneMesh constrained_mesh(PlaneCells cells, Bodies bodies);

}  // namespace graincrack::mesher
