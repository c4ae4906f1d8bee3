#include "post/measure/first_peak.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "post/statistics/statistics.hpp"

namespace graincrack {

namespace {

std::optional<double> residual_of(const MeanOverStrain& curve, double peak_strain) {
    const double end = peak_strain + residual_strains[1];
    if (curve.last_strain() < end) return std::nullopt;
    return curve.mean(peak_strain + residual_strains[0], end);
}

/// A line through means over equal parts of the strain, each as wide as the window of smoothing.
std::optional<double> rehardening_of(const MeanOverStrain& curve, double peak_strain) {
    const double begin = peak_strain + rehardening_strains[0];
    const double reached = std::min(curve.last_strain(), peak_strain + rehardening_strains[1]) - begin;
    if (reached < least_rehardening_strain) return std::nullopt;
    const auto parts = static_cast<std::size_t>(std::round(reached / smoothing_strain));
    const double width = reached / static_cast<double>(parts);
    std::vector<double> strain(parts);
    std::vector<double> stress(parts);
    for (std::size_t i = 0; i < parts; ++i) {
        strain[i] = begin + width * (static_cast<double>(i) + 0.5);
        stress[i] = curve.mean(strain[i] - 0.5 * width, strain[i] + 0.5 * width);
    }
    const std::optional<Line> line = fit_line(strain, stress);
    return line ? std::optional(line->slope) : std::nullopt;
}

}  // namespace

FirstPeak with_residual(const Peak& peak, const CurveColumns& curve, double confining_pressure) {
    FirstPeak first{peak, {}, {}, {}};
    const MeanOverStrain mean(curve.strain, curve.stress);
    first.residual = residual_of(mean, peak.strain);
    if (first.residual) first.drop = (peak.stress - *first.residual) / (peak.stress - confining_pressure);
    first.rehardening = rehardening_of(mean, peak.strain);
    return first;
}

std::optional<FirstPeak> measure_first_peak(const RunData& run, const LoadCurve& curve) {
    if (!is_compression(run.header) || !curve.strength) return std::nullopt;
    return with_residual(*curve.strength, curve.loaded(), run.header.confining_pressure);
}

}  // namespace graincrack
