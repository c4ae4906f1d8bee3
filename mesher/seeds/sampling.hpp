// Places the inner points of a mesh at random, but not too close to each other (Poisson disc).
#pragma once

#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "mesher/region/depth_grid.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Returns points no closer than `min_distance` to each other and `margin` to loops and prescribed edges, both times the local
/// size, so dense that hardly any further point has room; in the order of a Hilbert curve.
///
/// The method is Bridson's dart throwing (SIGGRAPH 2007) on a grid, linear in the number of points. Near each convex corner that
/// a grain could cut off, a point on the bisector lets two triangles share the corner.
/// \param depth of the region, with a reach of at least `margin` times the largest size
std::vector<Point> sample_points(const Region& region, const DepthGrid& depth, double min_distance, double margin,
                                 RandomNumbers& random, const SizeField& size = {});

}  // namespace graincrack::mesher
