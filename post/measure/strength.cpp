#include "post/measure/strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "post/statistics/statistics.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {

std::string name_of(StrengthKind kind) { return name_in({"largest", "first-peak", "residual"}, kind); }

std::string label_of(StrengthKind kind) { return name_in({"largest stress", "first peak", "residual strength"}, kind); }

std::optional<double> Strength::reported(StrengthKind kind) const {
    if (kind == StrengthKind::largest) return largest.stress;
    return kind == StrengthKind::residual && first_peak ? first_peak->residual_strength() : strength;
}

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

CurveRow curve_row(const RunData& run, const LoadCurve& curve, std::size_t row) {
    const History& history = run.history;
    const double force = (history[HistoryColumn::force_top][row] + history[HistoryColumn::force_bottom][row]) / 2;
    return {row,
            curve.stress[row],
            run.header.loading() == Loading::tension ? force : -force,
            curve.axial_strain[row],
            history[HistoryColumn::tensile_cracks][row],
            history[HistoryColumn::shear_cracks][row]};
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

Strength measure_strength(const RunData& run, const LoadCurve& curve) {
    Strength strength;
    if (curve.strength) strength.strength = curve.strength->stress;
    strength.peak = curve_row(run, curve, curve.peak);
    strength.largest = curve_row(run, curve, curve.largest);
    strength.largest_is_peak = has_fallen(run.header, curve.loaded());
    strength.peak_kind = peak_kind(run.header, curve.strength.has_value());
    strength.first_yield = first_yield(curve);
    strength.first_peak = measure_first_peak(run, curve);
    std::transform(strain_marks.begin(), strain_marks.end(), strength.stress_at_marks.begin(),
                   [&](double strain) { return stress_at_strain(curve, strain); });
    return strength;
}

bool stopped_at_strain_limit(const RunData& run, const Strength& strength, StrainLimitRuns strain_limit_runs,
                             const std::string& what) {
    if (strength.largest_is_peak) return false;
    if (run.header.stop_reason != "strain limit") {
        throw InputError(run.name + ": was stopped (" + run.header.stop_reason + ") before a peak; " + what +
                         " needs runs that fell behind their peak");
    }
    if (strain_limit_runs == StrainLimitRuns::refuse) {
        throw InputError(
            fmt::format("{}: stopped at the strain limit ({:.3g} %) without a peak, so that its largest stress is not a "
                        "strength; run it further (--max-strain), or accept the largest stress with --capped accept",
                        run.name, 100 * run.header.max_strain));
    }
    return true;
}

}  // namespace graincrack
