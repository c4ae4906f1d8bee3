// Turns a mesh of bodies into an assemblage: bodies with nodes of their own, contacts between them, boundary edges around them.
#pragma once

#include <vector>

#include "mesher/elements/plane_mesh.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Makes every body a grain. The cost is O(n log n) for n triangles.
///
/// Grains follow a Hilbert curve of their centres; nodes and elements follow their grains; contacts are ordered by (grain a,
/// grain b), those of one grain boundary along a1→a2; boundary edges are in the order of the mesh's sides. The function sets the
/// arrays; the caller sets shape, fabric, seed and statistics.
/// \param crystal_of_grain receives the crystal of every grain unless it is null
Specimen separate_bodies(const PlaneMesh& mesh, std::vector<int>* crystal_of_grain = nullptr);

}  // namespace graincrack::mesher
