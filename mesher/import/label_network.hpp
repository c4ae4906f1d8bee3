// All boundaries of a picture as segments that do not cross.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/import/label_smoothing.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

/// Points and segments with the pieces on both sides, lengths in pixels.
struct LabelNetwork {
    std::vector<Point> points;
    std::vector<RegionEdge> segments;
    int refined_chains = 0;  ///< chains that needed finer segments
};

/// Smooths the boundaries and divides them. Where two come closer than 0.5 pixels, cross, or meet at less than 20°, they are
/// divided more finely, down to the middles of the sides of pixels; so are segments more than three times as long as one that
/// they meet. \param spacing requested between points, pixels
LabelNetwork label_network(const LabelBoundaries& boundaries, double spacing);

/// What segments need of each other.
struct Clearance {
    double distance = 0;  ///< between segments without a common point, in the unit of the points
    double angle = 0;     ///< between segments that share a point, rad, below π/2
};

/// The segments, ascending, that need more of a distance from another, or of an angle with it. Two that cross are always among
/// them: the distance is far above the rounding of its computation.
std::vector<std::size_t> crowded_segments(std::span<const Point> points, std::span<const Edge> segments,
                                          const Clearance& clearance);

}  // namespace graincrack::mesher
