// Corrects imported meshes so that they can become specimens.
#pragma once

#include <string>
#include <vector>

#include "mesher/import/imported_mesh.hpp"

namespace graincrack::mesher {

/// Removes unused points, joins points at one place, reverses clockwise triangles, splits grains into pieces whose triangles
/// share sides, and sorts triangles by grain. Notes name each correction. The cost is about O(n log n) for n triangles.
/// \param name of the file, for messages
/// \throws InputError if a triangle has no area, two triangles overlap, a point lies on the side of a triangle without being its
///         corner, or the boundary crosses itself
void clean(ImportedMesh& mesh, const std::string& name);

/// A side of a single triangle, with the triangle on its left.
struct OpenSide {
    int from = 0, to = 0;
};
/// Sides that face no other triangle, in the order of their triangles.
std::vector<OpenSide> open_sides(const std::vector<Triangle>& triangles);

}  // namespace graincrack::mesher
