// All boundaries of a picture as segments that do not cross.
#pragma once

#include <vector>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/refined_triangulation.hpp"

namespace graincrack::mesher {

/// Points and segments with the pieces on both sides, lengths in pixels.
struct LabelNetwork {
    std::vector<Point> points;
    std::vector<RegionEdge> segments;
};

/// Smooths the boundaries and leaves points out: segments become about as long as the elements, but those of a closed boundary
/// are six or more. Pieces keep the areas of their pixels. Boundaries stay 0.5 pixels apart, and meet at 20° at least, where
/// points are left out. \param element side of triangles, pixels
LabelNetwork label_network(const LabelBoundaries& boundaries, double element);

}  // namespace graincrack::mesher
