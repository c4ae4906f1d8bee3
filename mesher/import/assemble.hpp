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

/// What is a body of the specimen: each grain of the file, whose elements deform together, or each element, so that the grains
/// are crystals that can break.
enum class CrystalChoice { elastic, breaking };

/// Makes a grain of each triangle. \return what its grain was
std::vector<int> make_grains_of_triangles(ImportedMesh& mesh);

/// Derives bodies, contacts, parts of the boundary, shape, phases and statistics. Grains of one triangle keep its corners in
/// their order, grains their order where the Hilbert curve of their centres has it, and a mesh whose middle is the origin is not
/// moved: a specimen that was exported comes back as it was. \param name of the file, for messages
/// \param notes what was decided, those of the mesh first. The crystals that grains are of are given to the specimen, the classes
/// of contacts within them are not (`name_crystals`): they follow from the phases. \throws InputError as `clean`, or if the
/// specimen is none that can be tested, or each crystal that is to break has one element
Specimen assemble(ImportedMesh mesh, const Placement& placement, CrystalChoice crystals, const std::string& name,
                  std::vector<Remark>& notes);

}  // namespace graincrack::mesher
