// Small arithmetic on columns for pictures.
#pragma once

#include <algorithm>
#include <vector>

namespace graincrack {

/// All values times a factor.
inline std::vector<double> times(std::vector<double> values, double factor) {
    for (double& value : values) value *= factor;
    return values;
}
/// 0 without values.
inline double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}
inline double smallest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::min_element(values.begin(), values.end());
}

}  // namespace graincrack
