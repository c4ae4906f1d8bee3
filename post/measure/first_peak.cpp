#include "post/measure/first_peak.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "post/statistics/statistics.hpp"

namespace graincrack {

MeanOverStrain::MeanOverStrain(std::span<const double> strain, std::span<const double> value) {
    for (std::size_t row = 0; row < strain.size(); ++row) {
        if (!strain_.empty() && !(strain[row] > strain_.back())) continue;
        const double area = strain_.empty() ? 0.0 : 0.5 * (value[row] + value_.back()) * (strain[row] - strain_.back());
        integral_.push_back(integral_.empty() ? 0.0 : integral_.back() + area);
        strain_.push_back(strain[row]);
        value_.push_back(value[row]);
    }
}

MeanOverStrain::Place MeanOverStrain::at(double strain) const {
    const auto above = std::upper_bound(strain_.begin(), strain_.end(), strain);
    if (above == strain_.begin()) return {value_.front(), 0};
    if (above == strain_.end()) return {value_.back(), integral_.back()};
    const auto end = static_cast<std::size_t>(above - strain_.begin());
    const double step = strain - strain_[end - 1];
    const double slope = (value_[end] - value_[end - 1]) / (strain_[end] - strain_[end - 1]);
    const double value = value_[end - 1] + slope * step;
    return {value, integral_[end - 1] + 0.5 * (value_[end - 1] + value) * step};
}

double MeanOverStrain::mean(double from, double to) const {
    const double low = std::max(from, first_strain());
    const double high = std::min(to, last_strain());
    if (!(high > low)) return at(low).value;
    return (at(high).integral - at(low).integral) / (high - low);
}

double MeanOverStrain::moving_mean(double strain, double width) const {
    const double half = std::max(0.0, std::min({0.5 * width, strain - first_strain(), last_strain() - strain}));
    return mean(strain - half, strain + half);
}

std::vector<double> moving_mean(std::span<const double> strain, std::span<const double> value, double width) {
    const MeanOverStrain curve(strain, value);
    std::vector<double> smooth(strain.size());
    std::transform(strain.begin(), strain.end(), smooth.begin(), [&](double at) { return curve.moving_mean(at, width); });
    return smooth;
}

namespace {

/// Row of the first maximum that the values fall behind, among the rows from the first failed contact on.
std::optional<std::size_t> first_peak_row(std::span<const double> value, std::span<const double> failed) {
    std::optional<std::size_t> highest;
    for (std::size_t row = 0; row < value.size(); ++row) {
        if (!highest && !(failed[row] > 0 && value[row] > 0)) continue;
        if (!highest || value[row] > value[*highest]) {
            highest = row;
        } else if (value[row] < first_peak_fall_to * value[*highest]) {
            return highest;
        }
    }
    return std::nullopt;
}

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

std::optional<FirstPeak> measure_first_peak(std::span<const double> axial_strain, std::span<const double> axial_stress,
                                            std::span<const double> failed, double confining_pressure) {
    std::vector<double> deviator = moving_mean(axial_strain, axial_stress, smoothing_strain);
    for (double& stress : deviator) stress -= confining_pressure;
    const std::optional<std::size_t> row = first_peak_row(deviator, failed);
    if (!row) return std::nullopt;
    FirstPeak peak;
    peak.strain = axial_strain[*row];
    peak.stress = deviator[*row] + confining_pressure;
    const MeanOverStrain curve(axial_strain, axial_stress);
    peak.residual = residual_of(curve, peak.strain);
    if (peak.residual) peak.drop = (peak.stress - *peak.residual) / deviator[*row];
    peak.rehardening = rehardening_of(curve, peak.strain);
    return peak;
}

std::optional<FirstPeak> measure_first_peak(const RunData& run, const LoadCurve& curve) {
    if (!is_compression(run.header)) return std::nullopt;
    std::vector<double> failed = run.history[HistoryColumn::tensile_cracks];
    const std::vector<double>& shear = run.history[HistoryColumn::shear_cracks];
    for (std::size_t row = 0; row < failed.size(); ++row) failed[row] += shear[row];
    const auto loaded = [&](const std::vector<double>& column) { return std::span(column).subspan(curve.start); };
    return measure_first_peak(loaded(curve.axial_strain), loaded(curve.stress), loaded(failed), run.header.confining_pressure);
}

}  // namespace graincrack
