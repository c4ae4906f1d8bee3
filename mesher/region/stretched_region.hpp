// A region as it lies in the plane where elongated grains are equiaxed.
#pragma once

#include "mesher/plane/stretch.hpp"
#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// The image of a region under `Stretch::equiaxed`; the region itself without elongation. Circles and arcs, which would become
/// ellipses, become polygons with sides of about a length `side` before the map.
Region stretched(const Region& region, const Stretch& stretch, double side);

}  // namespace graincrack::mesher
