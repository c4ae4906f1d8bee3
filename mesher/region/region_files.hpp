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

/// Straight flaws: columns x1_mm, y1_mm, x2_mm, y2_mm of their ends and, if there is one, `class`: `broken` (also if empty),
/// whose contacts are cracks from the start, or `intact`, which grain boundaries only follow. \throws InputError naming the file,
/// the line and what is wrong
std::vector<PrescribedEdge> read_flaws(const std::string& path);

}  // namespace graincrack::mesher
