// First positions of the inner points of a mesh: random, but not too close to each other (Poisson disc).
#pragma once

#include <vector>

#include "mesher/geometry.hpp"
#include "mesher/random_numbers.hpp"
#include "mesher/shape.hpp"

namespace graincrack::mesher {

/// Points no closer than `min_distance` to each other and no closer than `margin` to the boundary, so dense that there is room
/// for hardly any further point; in the order of a Hilbert curve.
///
/// Bridson's dart throwing (SIGGRAPH 2007) on a grid. Near each right corner of a rectangle one point is placed on the
/// bisector, so that corners are shared by two triangles.
std::vector<Point> sample_points(const Shape& shape, double min_distance, double margin, RandomNumbers& random);

}  // namespace graincrack::mesher
