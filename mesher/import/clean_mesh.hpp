// What files leave to be put right before an imported mesh can be a specimen.
#pragma once

#include <string>
#include <vector>

#include "mesher/import/imported_mesh.hpp"

namespace graincrack::mesher {

/// Leaves out unused points, joins points at one place, turns clockwise triangles, makes grains of the pieces of a grain whose
/// triangles share no sides, and sorts triangles by their grains; each is told in the notes.
/// \param name of the file, for messages
/// \throws InputError if a triangle has no area, two triangles overlap, a point lies on the side of a triangle without being its
///         corner, or the boundary crosses itself
void clean(ImportedMesh& mesh, const std::string& name);

/// A side that belongs to one triangle only, with the triangle on its left.
struct OpenSide {
    int from = 0, to = 0;
};
/// Sides of triangles that face none, ascending by their triangles.
std::vector<OpenSide> open_sides(const std::vector<Triangle>& triangles);

}  // namespace graincrack::mesher
