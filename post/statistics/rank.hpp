// Statistics by rank, on GSL.
#pragma once

#include <span>

namespace graincrack {

/// Spearman's rank correlation; ties by mean ranks. NaN if all values of one are equal. \pre equally many, two or more
double rank_correlation(std::span<const double> x, std::span<const double> y);

/// \pre values is not empty
double median(std::span<const double> values);

}  // namespace graincrack
