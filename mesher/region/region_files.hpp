// Reads tables of polygons, holes and flaws: TSV with one header line; lines that begin with # are skipped.
#pragma once

#include <string>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// Reads a polygon: columns x_mm and y_mm of its corners in order and optionally `part`, the name of the side from a corner to
/// the next. The first corner may be repeated at the end. Its middle need not be the origin. \throws InputError naming the file,
/// the line and the error, also for sides that cross
Region read_polygon(const std::string& path);

/// A round hole of a table.
struct Hole {
    Point centre;
    double radius = 0;  ///< m
    std::string name;   ///< for messages: "holes.tsv: line 3"
};
/// Reads round holes: columns x_mm, y_mm and radius_mm. \throws InputError naming the file, the line and the error
std::vector<Hole> read_holes(const std::string& path);

/// Reads straight flaws: columns x1_mm, y1_mm, x2_mm, y2_mm of their ends and optionally `class` and `state`. The class is
/// `broken` or empty (contacts are cracks from the start), `intact` (grain boundaries follow the line), or a name (contacts of
/// [flaws.NAME] of the material, intact unless their state is `broken`). \throws InputError naming the file, the line and the
/// error
std::vector<PrescribedEdge> read_flaws(const std::string& path);

}  // namespace graincrack::mesher
