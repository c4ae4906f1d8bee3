// Makes a specimen from an imported mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/import/imported_mesh.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Position and shape of an imported mesh.
struct Placement {
    double scale = 1;             ///< length of the unit of the file, m
    std::optional<Point> origin;  ///< point of the file that becomes the origin, m; missing: the middle of the extent
    std::string shape;            ///< shape of the specimen; "": by its outline
};

/// Bodies of the specimen: grains of the file, whose elements deform together, or elements, so that grains are crystals that can
/// break.
enum class CrystalChoice { elastic, breaking };

/// Makes each triangle a grain. \return [triangles] its former grain
std::vector<int> make_grains_of_triangles(ImportedMesh& mesh);

/// Derives bodies, contacts, boundary parts, shape, phases and statistics. Grains of one triangle keep the order of its corners;
/// grains keep their order if it is that of the Hilbert curve of their centres; a mesh centred on the origin is not moved. An
/// exported specimen is therefore imported unchanged. \param name of the file, for messages
/// \param notes receives decisions, after those of the mesh. The specimen gets the crystals of grains but not the classes of
/// contacts within them (`name_crystals`), which follow from the phases. \throws InputError as `clean`, or if the specimen cannot
/// be tested, or each breaking crystal has one element
Specimen assemble(ImportedMesh mesh, const Placement& placement, CrystalChoice crystals, const std::string& name,
                  std::vector<Remark>& notes);

}  // namespace graincrack::mesher
