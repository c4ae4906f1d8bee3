// The boundary of an imported mesh: what shape it has, and which parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/import/imported_mesh.hpp"
#include "mesher/seeds/seeds.hpp"

namespace graincrack::mesher {

struct Outline {
    std::string shape;
    double width = 0;   ///< extent along x
    double height = 0;  ///< extent along y; of a disc or a ring width and height are the extent between its poles
    Point middle;       ///< of the extent
    double loading_arc = 0;
    std::vector<Side> sides;  ///< those with names in the order of the file, then the others along the boundary
    std::vector<std::string> part_names;
};

/// Finds the outline of a clean mesh. A rectangle has the parts bottom, right, top and left, a disc its rim, a ring outer and
/// inner, a half-disc bottom and rim, any other a part "side"; holes are hole_1, …. Lines with names make parts of these names.
/// \param shape of the specimen, if it is not to be told by the outline (a beam is a rectangle)
/// \param notes lines whose names fit no place are told here
Outline outline_of(const ImportedMesh& mesh, const std::string& shape, const std::string& name, std::vector<Remark>& notes);

/// What contacts along a line of a name are: of `crack`, `flaw-NAME` and `flaw-NAME-broken`.
std::optional<FlawKind> flaw_of_line(const std::string& name);

}  // namespace graincrack::mesher
