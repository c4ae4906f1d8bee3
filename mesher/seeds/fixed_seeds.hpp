// Places fixed seeds: points on the loops of a region and on its prescribed edges.
#pragma once

#include "mesher/plane/random_numbers.hpp"
#include "mesher/region/region.hpp"
#include "mesher/seeds/seeds.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Number of boundary points, nearest to `requested`, that the region allows with the requested parity.
/// \param odd true if the number must be odd
int admissible_boundary_count(const Region& region, double requested, bool odd);

/// Length of all loops over the local size of grains, m; their perimeter without a size field.
double relative_perimeter(const Region& region, const SizeField& size);

/// Places `n` points on the loops in proportion to the lengths of their sides, and points at a spacing of `edge` (m) on the
/// prescribed edges. Lengths and spacings are over the local size. Spacings are random with the coefficient of variation
/// `spread`; the length of pole facets is not.
///
/// Points of a circle lie at the radius at which the polygon has its area. The nodes of pole facets (or the pole vertices) move
/// along their diameter until the polygon has the circle's extent there. Prescribed edges are clipped to the region and divided
/// where they meet; each is compared with each. Where they end on a loop, a point of the loop moves there or, if none is free,
/// one is added (two if needed for the parity). The polygon of a circle with moved points loses a little area.
/// \param n from `admissible_boundary_count`
/// \throws UsageError if prescribed edges lie upon each other
Seeds fixed_seeds(const Region& region, int n, double edge, double spread, RandomNumbers& random, const SizeField& size = {});

}  // namespace graincrack::mesher
