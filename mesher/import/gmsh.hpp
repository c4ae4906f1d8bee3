// Mesh files of Gmsh (MSH 2.2 and 4.1, as text) and of Neper, which are MSH 2.2 with sections of their own.
#pragma once

#include <string>
#include <string_view>

#include "mesher/import/file_mesh.hpp"

namespace graincrack::mesher {

/// Whether bytes begin as such a file does.
bool is_gmsh(std::string_view bytes);

/// Reads points, lines, triangles and quadrangles with their entities and physical groups; of Neper's meshes the entity is the
/// elset. Other sections are passed over.
/// \param name for messages \throws InputError naming the file, the place, what was found and what would be right
FileMesh read_gmsh(std::string_view bytes, const std::string& name);

}  // namespace graincrack::mesher
