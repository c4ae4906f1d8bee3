// Turns all boundaries of a picture into segments that do not cross.
#pragma once

#include <vector>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/refined_triangulation.hpp"

namespace graincrack::mesher {

/// Points, and segments with the pieces on both sides; lengths in pixels.
struct LabelNetwork {
    std::vector<Point> points;
    std::vector<RegionEdge> segments;
};

/// Smooths the boundaries and removes points: segments become about as long as elements, and closed boundaries keep at least six.
/// Pieces keep the areas of their pixels. Where points are removed, boundaries stay 0.5 pixels apart and meet at 20° or more.
/// \param element side of triangles, pixels
LabelNetwork label_network(const LabelBoundaries& boundaries, double element);

}  // namespace graincrack::mesher
