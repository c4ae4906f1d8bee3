// Divides a region into triangles of near-equal size without a preferred direction.
#pragma once

#include "mesher/cells/tessellation.hpp"

namespace graincrack::mesher {

/// A mesh has no preferred direction if |⟨e^(6iθ)⟩| is below these bounds, in the whole mesh and in each of eight equal parts,
/// for every `Partition`, in the plane where grains are equiaxed. Chosen by trial; not varied since.
inline constexpr double max_psi6 = 0.15;
inline constexpr double max_psi6_of_parts = 0.30;
/// Smallest angle, rad (8°), in the plane where grains are equiaxed. With holes, flaws or varying sizes, a mesh below it is made
/// again from other random numbers. Chosen by trial.
inline constexpr double smallest_angle = 0.14;

/// Plans a mesh. n triangles with b boundary points and h holes have (n + 2 − 2h − b)/2 inner points, so b and n are both even or
/// both odd.
MeshPlan plan_triangles(const Request& request);

/// Makes a mesh of seeds that are relaxed in the plane where grains are equiaxed. If psi6 exceeds the bounds, other random
/// numbers are used, up to 100 times (40 with holes and flaws), and the best mesh is kept. If an edge is requested, the number of
/// grains is corrected until the mean edge is within 0.5 %, or as near as whole grains allow.
TessellatedRegion triangles(const Request& request, MeshPlan plan, const ProgressCallback& progress);

/// Makes each triangle of relaxed seeds a cell, in the same order.
PlaneCells delaunay_cells(Seeds seeds);

}  // namespace graincrack::mesher
