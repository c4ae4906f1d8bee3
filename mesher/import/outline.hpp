// Finds the shape and the parts of the boundary of an imported mesh.
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
    double height = 0;  ///< extent along y; for a disc or a ring both are the extent between its poles
    Point middle;       ///< middle of the extent, m
    double loading_arc = 0;
    std::vector<Side> sides;  ///< named sides in the order of the file, then the others along the boundary
    std::vector<std::string> part_names;
};

/// Finds the outline of a clean mesh. A rectangle has the parts bottom, right, top and left, a disc its rim, a ring outer and
/// inner, a half-disc bottom and rim, any other shape a part "side"; holes are hole_1, …. Named lines become parts.
/// \param shape of the specimen, unless the outline determines it (a beam is a rectangle)
/// \param notes receives lines whose names fit no place
Outline outline_of(const ImportedMesh& mesh, const std::string& shape, const std::string& name, std::vector<Remark>& notes);

/// Kind of the contacts along a named line: `crack`, `flaw-NAME` and `flaw-NAME-broken`.
std::optional<FlawKind> flaw_of_line(const std::string& name);

}  // namespace graincrack::mesher
