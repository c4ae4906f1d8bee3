// From an imported mesh to a specimen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/import/imported_mesh.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Where and as what a mesh is placed.
struct Placement {
    double scale = 1;             ///< m for one unit of the file
    std::optional<Point> origin;  ///< point of the file, m, that becomes the origin; none: the middle of the extent
    std::string shape;            ///< of the specimen; "" by its outline
};

/// Derives bodies, contacts, parts of the boundary, shape, phases and statistics. Grains of one triangle keep its corners in
/// their order, grains their order where the Hilbert curve of their centres has it, and a mesh whose middle is the origin is not
/// moved: a specimen that was exported comes back as it was. \param name of the file, for messages
/// \param notes what was decided, those of the mesh first
/// \throws InputError as `clean`, or if the specimen is none that can be tested
Specimen assemble(ImportedMesh mesh, const Placement& placement, const std::string& name, std::vector<std::string>& notes);

}  // namespace graincrack::mesher
