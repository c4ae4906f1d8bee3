// What a file from elsewhere says about a specimen; all else is derived from it by `assemble`.
#pragma once

#include <string>
#include <vector>

#include "mesher/import/label_table.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"
#include "share/base/events.hpp"

namespace graincrack::mesher {

/// A side of triangles that a file gives a name: of a part of the boundary, or of contacts. Inside, `crack` makes contacts that
/// are broken from the start, `flaw-NAME` such of the class NAME of flaws, `flaw-NAME-broken` both.
struct NamedLine {
    int from = 0, to = 0;
    std::string name;
};

/// Triangles, each with the number of its grain. Nothing else is asked of a file: points may be doubled or unused, triangles of
/// either direction, a grain of several pieces.
struct ImportedMesh {
    std::vector<Point> points;  ///< in the unit of the file
    std::vector<Triangle> triangles;
    std::vector<int> grain_of_triangle;       ///< from 0
    std::vector<std::string> phase_of_grain;  ///< "" where the file does not say
    std::vector<std::string> phases;          ///< order of their numbers; others follow as they appear
    std::vector<NamedLine> lines;
    std::vector<LabelRow> labels;  ///< of a picture
    std::string format;            ///< "Gmsh 4.1, binary", for the report
    std::vector<Remark> notes;     ///< what was decided, a line each; warnings of what is wrong or lost
};

}  // namespace graincrack::mesher
