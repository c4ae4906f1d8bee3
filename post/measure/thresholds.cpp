#include "post/measure/thresholds.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "post/statistics/statistics.hpp"

namespace graincrack {

namespace {

/// Row of the largest contraction, if the volume grows again behind the elastic part and before the peak.
std::optional<std::size_t> reversal(const std::vector<double>& volume, const LoadCurve& curve) {
    const auto row_at = [&](std::size_t row) { return volume.begin() + static_cast<std::ptrdiff_t>(row); };
    const auto largest = std::max_element(row_at(curve.start), row_at(curve.peak + 1));
    const auto row = static_cast<std::size_t>(largest - volume.begin());
    if (row == curve.peak || row <= rows_between(curve, elastic_share[0], elastic_share[1]).begin) return std::nullopt;
    return row;
}

std::optional<double> by_crack_strain(const LoadCurve& curve, const std::vector<double>& volume) {
    const std::vector<double> cracks = crack_strain(curve, volume);
    if (cracks.empty()) return std::nullopt;
    for (std::size_t i = rows_between(curve, elastic_share[0], elastic_share[1]).end; i <= curve.peak; ++i) {
        if (cracks[i] <= -crack_strain_offset) return curve.shown_stress(i);
    }
    return std::nullopt;
}

/// Stress at which a count, which never falls, first reaches a share of what it has grown by from the start to the peak.
std::optional<double> where_counts_begin(const LoadCurve& curve, const std::vector<double>& counts, double share) {
    const auto count = [&](std::size_t row) { return counts[row] - counts[curve.start]; };
    const double at_peak = count(curve.peak);
    if (!(at_peak > 0)) return std::nullopt;
    for (std::size_t row = curve.start; row <= curve.peak; ++row) {
        if (count(row) > 0 && count(row) >= share * at_peak) return curve.shown_stress(row);
    }
    return std::nullopt;
}

}  // namespace

std::vector<double> volumetric_strain(const LoadCurve& curve, VolumeKind kind) {
    const double sides = kind == VolumeKind::plane ? 1 : 2;
    std::vector<double> volume = curve.gauge_axial_strain;
    for (std::size_t i = 0; i < volume.size(); ++i) volume[i] -= sides * curve.gauge_lateral_strain[i];
    return volume;
}

std::vector<double> crack_strain(const LoadCurve& curve, const std::vector<double>& volume) {
    const RowRange elastic = rows_between(curve, elastic_share[0], elastic_share[1]);
    const std::size_t n = elastic.end - elastic.begin;
    const auto line = fit_line(std::span(curve.stress).subspan(elastic.begin, n), std::span(volume).subspan(elastic.begin, n));
    if (!line) return {};
    std::vector<double> cracks(volume.size());
    for (std::size_t i = 0; i < cracks.size(); ++i) cracks[i] = volume[i] - line->intercept - line->slope * curve.stress[i];
    return cracks;
}

Thresholds measure_thresholds(const LoadCurve& curve, VolumeKind kind) {
    const std::vector<double> volume = volumetric_strain(curve, kind);
    Thresholds thresholds;
    thresholds.initiation_by_crack_strain = by_crack_strain(curve, volume);
    if (const auto damage = reversal(volume, curve)) thresholds.damage = curve.shown_stress(*damage);
    return thresholds;
}

std::optional<double> initiation_by_count(const RunData& run, const LoadCurve& curve, double share) {
    std::vector<double> counts = run.history[HistoryColumn::tensile_cracks];
    const auto& shear = run.history[HistoryColumn::shear_cracks];
    std::transform(counts.begin(), counts.end(), shear.begin(), counts.begin(), std::plus<>());
    return where_counts_begin(curve, counts, share);
}

std::optional<double> initiation_by_damage(const RunData& run, const LoadCurve& curve, const std::vector<Crack>& cracks,
                                           double share) {
    const auto& row_times = run.history[HistoryColumn::time];
    std::vector<double> counts(row_times.size());
    for (const Crack& crack : cracks) {
        const double time = crack.damaged_10.time;
        const auto row = std::lower_bound(row_times.begin(), row_times.end(), time);
        if (row != row_times.end() && time <= *row) counts[static_cast<std::size_t>(row - row_times.begin())] += 1;
    }
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
    return where_counts_begin(curve, counts, share);
}

AllThresholds measure_all_thresholds(const RunData& run, const LoadCurve& curve, const std::vector<Crack>& cracks) {
    return {measure_thresholds(curve, VolumeKind::plane), measure_thresholds(curve, VolumeKind::pseudo_3d),
            initiation_by_count(run, curve), initiation_by_damage(run, curve, cracks)};
}

}  // namespace graincrack
