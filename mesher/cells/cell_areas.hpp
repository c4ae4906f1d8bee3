// Requested areas of polygonal cells.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/fabric/fabric.hpp"
#include "mesher/plane/random_numbers.hpp"

namespace graincrack::mesher {

/// Error of areas that ends iterations, over the requested ones.
inline constexpr double allowed_area_error = 1e-8;

/// Areas of `n` cells at random, whose sum is `total`. The coefficient of variation of their diameters (standard deviation over
/// mean) is `spread` exactly; where so few cells allow less, as much as they do.
std::vector<double> requested_areas(std::size_t n, double total, double spread, SizeDistribution distribution,
                                    RandomNumbers& random);

/// Coefficient of variation of the diameters of circles of given areas.
double diameter_variation(const std::vector<double>& areas);

}  // namespace graincrack::mesher
