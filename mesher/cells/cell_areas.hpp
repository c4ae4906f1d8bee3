// Wanted areas of polygonal cells.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/plane/random_numbers.hpp"

namespace graincrack::mesher {

/// Distribution of the diameters of cells, which are those of circles of equal area. Both are cut off three standard deviations
/// from their middle, the normal one also at a quarter of it.
enum class SizeDistribution { normal, lognormal };

/// What iterations bring areas to, over the wanted ones.
inline constexpr double wanted_area_error = 1e-8;

/// Areas of `n` cells at random, whose sum is `total`. The coefficient of variation of their diameters (standard deviation over
/// mean) is `spread` exactly; where so few cells allow less, as much as they do.
std::vector<double> wanted_areas(std::size_t n, double total, double spread, SizeDistribution distribution,
                                 RandomNumbers& random);

/// Coefficient of variation of the diameters of circles of given areas.
double diameter_variation(const std::vector<double>& areas);

}  // namespace graincrack::mesher
