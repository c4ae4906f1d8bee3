// From a mesh of bodies to an assemblage: bodies with nodes of their own, contacts between them, boundary edges around them.
#pragma once

#include <vector>

#include "mesher/elements/plane_mesh.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Makes every body a grain.
///
/// Grains follow a Hilbert curve of their centres; nodes and elements follow their grains; contacts are ordered by
/// (grain a, grain b), those of one grain boundary along a1→a2; boundary edges are in the order of the mesh's sides.
/// Sets the arrays; the caller sets what the specimen is, its fabric, seed and statistics.
/// \param crystal_of_grain filled unless null: the crystal of every grain
Specimen separate_bodies(const PlaneMesh& mesh, std::vector<int>* crystal_of_grain = nullptr);

}  // namespace graincrack::mesher
