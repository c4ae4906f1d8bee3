// Tessellation files of Neper (.tess): polygonal cells without elements.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesher/import/file_mesh.hpp"

namespace graincrack::mesher {

/// Whether bytes begin as such a file does.
bool is_neper_tess(std::string_view bytes);

/// Reads the cells of a tessellation of two dimensions (formats 2.0 and 3.3 to 3.5) and divides each into triangles, whose points
/// on sides both cells have. Grains are cells; phases come from the key alone, by the numbers of cells.
/// \param element_size requested side of triangles in the unit of the file; none: a third of the mean equal-area diameter of cells
/// \param name for messages \throws InputError naming the file, the line, what was found and what would be right
ImportedMesh import_neper_tess(std::string_view bytes, const PhaseKey& key, std::optional<double> element_size,
                               const std::string& name);

}  // namespace graincrack::mesher
