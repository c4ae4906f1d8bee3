// Which segments of boundaries cross, come too close, or meet at too small an angle.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

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
