// Meshes as files of VTK.
#pragma once

#include <string>

#include "post/export/shared_mesh.hpp"

namespace graincrack {

/// The content of a .vtu file: triangles with points (m, z = 0) that grains share. Cell data: grain (from 0), phase, grain_area
/// (m²). Field data: phase_names. zlib and base64, which most readers know. \throws OutputError
std::string vtu_text(const SharedMesh& mesh);

}  // namespace graincrack
