// Values that change with temperature.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace graincrack {

/// A value at a temperature, how it changes per K, and its integral from 0 K, the state without stress.
struct ValueAtTemperature {
    double value, slope, integral;
};
inline ValueAtTemperature constant_value(double value, double temperature) { return {value, 0, value * temperature}; }

/// Temperatures (K), ascending, with values: linear between, constant outside. Without any there is no curve.
using TemperatureCurve = std::vector<std::array<double, 2>>;
/// \param curve with one temperature at least
inline ValueAtTemperature value_at(const TemperatureCurve& curve, double temperature) {
    ValueAtTemperature at = constant_value(curve.front()[1], temperature);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const double from = curve[i - 1][0], to = curve[i][0];
        const double slope = (curve[i][1] - curve[i - 1][1]) / (to - from);
        const auto past = [from, to](double t) { return std::clamp(t, from, to) - from; };
        const auto area = [&](double t) { return 0.5 * past(t) * past(t) + std::max(t - to, 0.0) * (to - from); };
        at.value += slope * past(temperature);
        at.integral += slope * (area(temperature) - area(0));
        if (from <= temperature && temperature < to) at.slope = slope;
    }
    return at;
}

}  // namespace graincrack
