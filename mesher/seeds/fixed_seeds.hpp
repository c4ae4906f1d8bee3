// Fixed seeds: points on the loops of a region and on its prescribed edges.
#pragma once

#include "mesher/plane/random_numbers.hpp"
#include "mesher/region/region.hpp"
#include "mesher/seeds/seeds.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Number of boundary points nearest to `requested` that the region allows, of the requested parity.
/// \param odd true if the number must be odd
int admissible_boundary_count(const Region& region, double requested, bool odd);

/// Length of all loops over the local size of grains, m; without a size field their perimeter.
double relative_perimeter(const Region& region, const SizeField& size);

/// Places `n` points on the loops, shared in proportion to the lengths of their sides, and points at a spacing of `edge` on the
/// prescribed edges; lengths and spacings are those over the local size. Spacings vary at random with coefficient of variation
/// `spread`; the length of pole facets does not vary.
///
/// Points of a circle lie at the radius that gives the polygon the area of the circle; the pole facets' nodes (or the pole
/// vertices) are moved along their diameter so that the polygon has the circle's extent there. Prescribed edges are clipped to
/// the region and divided where they meet; where they end on a loop, a point of the loop is moved there or, if none is free,
/// added (two if needed to keep the parity). The polygon of a circle whose points are moved loses a little of its area.
/// \param n from `admissible_boundary_count`
/// \throws UsageError if prescribed edges lie upon each other
Seeds fixed_seeds(const Region& region, int n, double edge, double spread, RandomNumbers& random, const SizeField& size = {});

}  // namespace graincrack::mesher
