// Tables that describe regions: polygons and flaws. TSV with one header line; lines that begin with # are passed over.
#pragma once

#include <string>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// A polygon: columns x_mm and y_mm of its corners in their order and, if there is one, `part`: the name of the side from a
/// corner to the next. The first corner may stand at the end again. Its middle need not be the origin. \throws InputError naming
/// the file, the line and what is wrong, also for sides that cross
Region read_polygon(const std::string& path);

/// A round hole of a table.
struct Hole {
    Point centre;
    double radius = 0;  ///< m
    std::string name;   ///< for messages: "holes.tsv: line 3"
};
/// Round holes: columns x_mm, y_mm and radius_mm. \throws InputError naming the file, the line and what is wrong
std::vector<Hole> read_holes(const std::string& path);

/// Straight flaws: columns x1_mm, y1_mm, x2_mm, y2_mm of their ends and, if there are such, `class` and `state`. The class is
/// `broken` (also if empty), whose contacts are cracks from the start, `intact`, which grain boundaries only follow, or a name:
/// contacts of [flaws.NAME] of the material, intact unless their state is `broken`. \throws InputError naming the file,
/// the line and what is wrong
std::vector<PrescribedEdge> read_flaws(const std::string& path);

}  // namespace graincrack::mesher
