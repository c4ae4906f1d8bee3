// Axes of charts: label, range and ticks.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/picture_style.hpp"

namespace graincrack {

/// An axis with its label, unit and range.
struct Axis {
    std::string label;  ///< "axial strain, %"
    double low = 0;
    double high = 1;
    bool logarithmic = false;

    /// Position of a value: 0 at `low`, 1 at `high`.
    [[nodiscard]] double share(double value) const;
    /// Unit after the comma of the label: "%"; "" for a number without unit.
    [[nodiscard]] std::string unit() const;
    /// The axis with other limits. \throws UsageError for a logarithmic axis from 0 or below
    [[nodiscard]] Axis limited(const AxisLimits& limits) const;
};

/// The ticks of an axis with their texts. Very large and very small values share a power of ten, which the label has: "opening,
/// 10⁻⁶ m".
struct Ticks {
    std::vector<double> values;
    std::vector<std::string> texts;
    std::string label;  ///< label of the axis
};
/// Ticks at round values. \param wanted their approximate number
Ticks ticks_of(const Axis& axis, int wanted);
/// As many ticks as have room for their texts side by side, at most `wanted`. \param length of the axis, pixels
Ticks ticks_along(const Axis& axis, double length, double text_size, int wanted);

/// Smallest and largest value without NaN, widened by a fraction `pad` of their distance; {0, 1} without values.
std::pair<double, double> padded_range(std::span<const double> values, double pad);

/// Label of a column: "contact_cohesion_MPa" → "contact cohesion, MPa"; "phi_deg" → "φ, °".
std::string column_label(const std::string& column);
/// Printed name of a mineral or of a pair: "k_feldspar" → "K-feldspar"; "k_feldspar-mica" → "K-feldspar–mica".
std::string mineral_label(const std::string& name);

/// Values times a factor.
inline std::vector<double> times(std::vector<double> values, double factor) {
    for (double& value : values) value *= factor;
    return values;
}
/// Counts from the last zero before the first count on, NaN before: a line of zeros would hide the axis.
inline std::vector<double> from_first(std::vector<double> counts) {
    for (std::size_t i = 0; i + 1 < counts.size() && counts[i + 1] == 0; ++i) counts[i] = std::nan("");
    return counts;
}
/// Largest and smallest value; 0 without values.
inline double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}
inline double smallest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::min_element(values.begin(), values.end());
}

}  // namespace graincrack
