// All boundaries of a picture as segments that do not cross.
#pragma once

#include <span>
#include <vector>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/import/label_smoothing.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/refined_triangulation.hpp"

namespace graincrack::mesher {

/// Points and segments with the pieces on both sides, lengths in pixels.
struct LabelNetwork {
    std::vector<Point> points;
    std::vector<RegionEdge> segments;
    int refined_chains = 0;  ///< chains that needed finer segments
};

/// Smooths the boundaries and divides them. Where two come closer than 0.5 pixels, cross, or meet at less than 20°, they are
/// divided more finely, down to the middles of the sides of pixels (jagged: to their corners); so are segments more than three
/// times as long as one that they meet, and all around a piece whose area would be more than 10 % off that of its pixels.
LabelNetwork label_network(const LabelBoundaries& boundaries, std::span<const int> pixels_of_piece, const Smoothing& smoothing);

}  // namespace graincrack::mesher
