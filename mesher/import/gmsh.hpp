// Reads mesh files of Gmsh (MSH 2.2 and 4.1, text) and of Neper (MSH 2.2 with additional sections).
#pragma once

#include <string>
#include <string_view>

#include "mesher/import/file_mesh.hpp"

namespace graincrack::mesher {

/// True if bytes begin like such a file.
bool is_gmsh(std::string_view bytes);

/// Reads points, lines, triangles and quadrangles with their entities and physical groups; the entity in Neper's meshes is the
/// elset. Other sections are skipped.
/// \param name for messages \throws InputError naming the file, the place, what was found and what would be right
FileMesh read_gmsh(std::string_view bytes, const std::string& name);

}  // namespace graincrack::mesher
