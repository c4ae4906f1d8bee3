// A region divided into triangles of near-equal size without a preferred direction.
#pragma once

#include "mesher/cells/tessellation.hpp"

namespace graincrack::mesher {

/// A mesh counts as free of a preferred direction if |⟨e^(6iθ)⟩| is below these bounds, in the whole mesh and in each of eight
/// equal parts, for every `Partition`; of elongated grains in the plane where they are equiaxed.
inline constexpr double max_psi6 = 0.15;
inline constexpr double max_psi6_of_parts = 0.30;
/// With holes, flaws or sizes that differ, a mesh with a smaller angle, rad (8°), is made again from other random numbers too; of
/// elongated grains in the plane where they are equiaxed.
inline constexpr double smallest_angle = 0.14;

/// A mesh of n triangles with b boundary points and h holes has (n + 2 − 2h − b)/2 inner points, so b and n are both even or both
/// odd.
MeshPlan plan_triangles(const Request& request);

/// Seeds are relaxed in the plane where grains are equiaxed. A mesh whose psi6 is above the bounds is made again from other
/// random numbers, up to 100 times, with holes and flaws 40; the best mesh is kept. If an edge is requested, the number of grains
/// is corrected until the mean edge is within 0.5 %, or as near as whole grains allow.
TessellatedRegion triangles(const Request& request, MeshPlan plan, const ProgressCallback& progress);

/// Makes each triangle of relaxed seeds a cell, in the same order.
PlaneCells delaunay_cells(Seeds seeds);

}  // namespace graincrack::mesher
