#include "share/file/peak.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

std::vector<double> failed_contacts(const History& history) {
    std::vector<double> failed = history[HistoryColumn::tensile_cracks];
    const std::vector<double>& shear = history[HistoryColumn::shear_cracks];
    for (std::size_t row = 0; row < failed.size(); ++row) failed[row] += shear[row];
    return failed;
}

namespace {

std::size_t row_of_largest(std::span<const double> stress) {
    return static_cast<std::size_t>(std::max_element(stress.begin(), stress.end()) - stress.begin());
}

/// The row of the largest stress among those next to a row within `smoothing_strain` of it.
std::size_t largest_about(std::size_t row, const CurveColumns& curve) {
    const auto is_near = [&](std::size_t other) { return std::abs(curve.strain[other] - curve.strain[row]) <= smoothing_strain; };
    std::size_t begin = row, end = row + 1;
    while (begin > 0 && is_near(begin - 1)) --begin;
    while (end < curve.strain.size() && is_near(end)) ++end;
    return begin + row_of_largest(curve.stress.subspan(begin, end - begin));
}

}  // namespace

PeakRule peak_rule(const RunSettings& header) {
    if (header.heat == 0) return {};
    return {heated_fall, settling_load * header.rock.tensile_strength, heated_peak};
}

std::optional<Peak> find_first_peak(const CurveColumns& curve, double confining_pressure, const PeakRule& rule) {
    std::vector<double> deviator = moving_mean(curve.strain, curve.stress, smoothing_strain);
    for (double& stress : deviator) stress -= confining_pressure;
    const double least = std::max(rule.least_load, rule.share * *std::max_element(deviator.begin(), deviator.end()));
    std::optional<std::size_t> highest;
    double furthest = -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < deviator.size(); ++row) {
        if (!(curve.strain[row] > furthest)) continue;
        furthest = curve.strain[row];
        if (!highest && !(curve.failed[row] > 0 && deviator[row] > least)) continue;
        if (!highest || deviator[row] > deviator[*highest]) {
            highest = row;
        } else if (deviator[row] < (1 - rule.fall) * deviator[*highest]) {
            return Peak{largest_about(*highest, curve), curve.strain[*highest], deviator[*highest] + confining_pressure};
        }
    }
    return std::nullopt;
}

bool has_fallen(const RunHeader& header, const CurveColumns& curve) {
    if (header.stop_reason == "peak drop") return true;
    if (!(curve.failed.back() > 0)) return false;
    const std::size_t largest = row_of_largest(curve.stress);
    const double peak = curve.stress[largest];
    const double fallen =
        peak - peak_rule(header).fall * (peak - (header.loading() == Loading::compression ? header.confining_pressure : 0));
    for (std::size_t row = largest + 1; row < curve.stress.size(); ++row) {
        if (curve.strain[row] > curve.strain[largest] && curve.stress[row] <= fallen) return true;
    }
    return false;
}

std::optional<Peak> find_strength(const RunHeader& header, const CurveColumns& curve) {
    if (header.loading() == Loading::compression) {
        if (const auto first = find_first_peak(curve, header.confining_pressure, peak_rule(header))) return first;
    }
    if (!has_fallen(header, curve)) return std::nullopt;
    const std::size_t largest = row_of_largest(curve.stress);
    return Peak{largest, curve.strain[largest], curve.stress[largest]};
}

std::optional<Peak> find_strength(const RunHeader& header, const History& history, double sense) {
    const std::vector<double>& times = history[HistoryColumn::time];
    const auto begin = std::lower_bound(times.begin(), times.end(), header.isotropic_end_time * (1 - 1e-12));
    if (begin == times.end()) return std::nullopt;
    const auto loaded = [&](HistoryColumn column) {
        std::vector<double> rows(history[column].begin() + (begin - times.begin()), history[column].end());
        for (double& value : rows) value *= sense;
        return rows;
    };
    const std::vector<double> strain = loaded(HistoryColumn::axial_strain);
    const std::vector<double> stress = loaded(HistoryColumn::axial_stress);
    const std::vector<double> failed = failed_contacts(history);
    std::optional<Peak> peak = find_strength(header, {strain, stress, std::span(failed).last(strain.size())});
    if (peak) peak->row += static_cast<std::size_t>(begin - times.begin());
    return peak;
}

}  // namespace graincrack
