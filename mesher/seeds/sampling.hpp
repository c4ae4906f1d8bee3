// First positions of the inner points of a mesh: random, but not too close to each other (Poisson disc).
#pragma once

#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "mesher/region/depth_grid.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Points no closer than `min_distance` to each other and no closer than `margin` to loops and prescribed edges, both times the
/// local size, so dense that there is room for hardly any further point; in the order of a Hilbert curve.
///
/// Bridson's dart throwing (SIGGRAPH 2007) on a grid. Near each convex corner that a grain could cut off one point is placed on
/// the bisector, so that such corners are shared by two triangles.
/// \param depth of the region, with a reach of `margin` times the largest size at least
std::vector<Point> sample_points(const Region& region, const DepthGrid& depth, double min_distance, double margin,
                                 RandomNumbers& random, const SizeField& size = {});

}  // namespace graincrack::mesher
