// The content of a file of another program; `assemble` derives everything else.
#pragma once

#include <string>
#include <vector>

#include "mesher/import/label_table.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"
#include "share/base/events.hpp"

namespace graincrack::mesher {

/// A named side of triangles, on the boundary or inside. Inside, `crack` makes contacts that are broken from the start,
/// `flaw-NAME` contacts of the class NAME of flaws, `flaw-NAME-broken` both.
struct NamedLine {
    int from = 0, to = 0;
    std::string name;
};

/// Triangles with the number of their grain. Nothing else is required of a file: points may be doubled or unused, triangles may
/// have either direction, and grains several pieces.
struct ImportedMesh {
    std::vector<Point> points;  ///< in the unit of the file
    std::vector<Triangle> triangles;
    std::vector<int> grain_of_triangle;       ///< from 0
    std::vector<std::string> phase_of_grain;  ///< "" if the file has none
    std::vector<std::string> phases;          ///< phases in the order of their numbers; others follow as they appear
    std::vector<NamedLine> lines;
    std::vector<LabelRow> labels;  ///< of a picture
    std::string format;            ///< "Gmsh 4.1, binary", for the report
    std::vector<Remark> notes;     ///< decisions, one per line; warnings of errors or losses
};

}  // namespace graincrack::mesher
