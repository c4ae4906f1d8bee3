#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "post/measure/thresholds.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

/// Strains in % since the start of axial loading, up to just past the peak.
struct Strains {
    std::vector<double> stress;  ///< MPa
    std::vector<double> axial;
    std::vector<double> lateral;  ///< positive in contraction, like the others
    std::vector<double> volume;   ///< pseudo-3D
    std::vector<double> cracks;   ///< `volume` minus its elastic line; empty without one
    std::size_t peak = 0;
};

Strains strains_of(const LoadCurve& curve) {
    const std::vector<double> volume = volumetric_strain(curve, VolumeKind::pseudo_3d);
    const std::vector<double> cracks = crack_strain(curve, volume);
    Strains s;
    s.peak = curve.peak - curve.start;
    const double last = 1.05 * curve.gauge_axial_strain[curve.peak];
    for (std::size_t i = curve.start; i < curve.stress.size(); ++i) {
        if (i > curve.peak && curve.gauge_axial_strain[i] > last) break;
        s.stress.push_back(1e-6 * curve.shown_stress(i));
        s.axial.push_back(100 * (curve.gauge_axial_strain[i] - curve.gauge_axial_strain[curve.start]));
        s.lateral.push_back(-100 * (curve.gauge_lateral_strain[i] - curve.gauge_lateral_strain[curve.start]));
        s.volume.push_back(100 * (volume[i] - volume[curve.start]));
        if (!cracks.empty()) s.cracks.push_back(100 * cracks[i]);
    }
    return s;
}

/// The smallest and the largest value up to the peak.
std::pair<double, double> range_to_peak(const Strains& s, const std::vector<double>& values) {
    return padded_range(std::span(values).first(std::min(values.size(), s.peak + 1)), 0);
}

/// The value of a column at a threshold, whose stress is that of a row.
double at_stress(const Strains& s, const std::vector<double>& column, double stress) {
    const auto row = std::find(s.stress.begin(), s.stress.end(), stress);
    return column[std::min(static_cast<std::size_t>(row - s.stress.begin()), column.size() - 1)];
}

/// One of the default thresholds.
struct Threshold {
    const char* name;
    const char* symbol;
    const char* by;
    std::optional<double> stress;  ///< MPa
    Stroke stroke;
    Marker marker;  ///< marker at its place
};

std::array<Threshold, 2> default_thresholds(const AllThresholds& all) {
    const auto megapascals = [](const std::optional<double>& stress) {
        return stress ? std::optional(1e-6 * *stress) : std::nullopt;
    };
    return {{{"crack initiation",
              "CI",
              default_initiation_name,
              megapascals(all.initiation()),
              {palette::tensile, 3, Dash::dashed},
              {palette::tensile, MarkerShape::disc, 18}},
             {"crack damage",
              "CD",
              default_damage_name,
              megapascals(all.damage()),
              {palette::shear, 3, Dash::dash_dot},
              {palette::shear, MarkerShape::square, 18}}}};
}

const Stroke axial_stroke{palette::series(0), 4.5};
const Stroke lateral_stroke{palette::series(1), 4, Dash::long_dashed};
const Stroke volume_stroke{palette::series(2), 4};
const Stroke crack_stroke{palette::series(3), 4, Dash::long_dashed};

std::string legend_of(const Threshold& threshold, double peak_stress) {
    const std::string name = fmt::format("{} {}: ", threshold.name, threshold.symbol);
    if (!threshold.stress) return name + "not reached before the peak";
    return name + fmt::format("{:.1f} MPa, {:.2f} of the peak", *threshold.stress, *threshold.stress / peak_stress);
}

using Places = std::vector<Chart::Place>;

/// Labels the curves and lines of the upper chart at free places.
void label_curves(Chart& chart, const Strains& s, const std::array<Threshold, 2>& defaults, const Axis& x) {
    struct Curve {
        const std::vector<double>& strain;
        const char* symbol;
        const Stroke& stroke;
    };
    const std::array<Curve, 3> curves{
        {{s.axial, "ε1", axial_stroke}, {s.lateral, "ε3", lateral_stroke}, {s.volume, "ε1 + 2 ε3", volume_stroke}}};
    Places levels;
    for (const Threshold& threshold : defaults) {
        if (!threshold.stress) continue;
        for (double share = 0; share <= 1; share += 0.01) levels.push_back({x.low + share * (x.high - x.low), *threshold.stress});
    }
    const auto points_but = [&](const Curve* own) {
        Places points;
        for (const Curve& each : curves) {
            if (&each == own) continue;
            for (std::size_t i = 0; i < s.stress.size(); ++i) points.push_back({each.strain[i], s.stress[i]});
        }
        return points;
    };
    for (const Threshold& threshold : defaults) {
        if (!threshold.stress) continue;
        Places places;
        for (const double share : {0.95, 0.9, 0.85, 0.05, 0.1, 0.15, 0.2}) {
            places.push_back({x.low + share * (x.high - x.low), *threshold.stress});
        }
        chart.label_line(places, threshold.symbol, threshold.stroke.colour, points_but(nullptr));
    }
    for (const Curve& curve : curves) {
        Places others = points_but(&curve);
        others.insert(others.end(), levels.begin(), levels.end());
        Places places;
        for (const double share : {0.7, 0.65, 0.75, 0.6, 0.8, 0.55, 0.5, 0.3, 0.25}) {
            const double wanted = s.stress[0] + share * (s.stress[s.peak] - s.stress[0]);
            const auto row = std::find_if(s.stress.begin(), s.stress.end(), [&](double stress) { return stress >= wanted; });
            places.push_back({curve.strain[static_cast<std::size_t>(row - s.stress.begin())], *row});
        }
        chart.label_line(places, curve.symbol, curve.stroke.colour, others);
    }
}

/// Left edge of both frames, pixels.
constexpr double left_edge = 140;

Drawing stress_chart(const RunData& run, const Strains& s, const AllThresholds& all, const PictureStyle& style) {
    const double high = range_to_peak(s, s.axial).second;
    const double left = std::min(range_to_peak(s, s.lateral).first, range_to_peak(s, s.volume).first);
    const double low = std::clamp(left, -0.6 * high, 0.0);
    const Axis x{"strain by gauges, % (lateral left, axial right)", low - 0.08 * (high - low), high + 0.08 * (high - low)};
    ChartText text{
        test_title(run.header),
        {"plane " + std::string(name_of(run.header.plane)) + "; contraction positive; the third strain is taken as ε3"}};
    Chart chart(style, text, x, Axis{"axial stress, MPa", 0, 1.1 * largest(s.stress)}, {.min_left = left_edge});
    const auto defaults = default_thresholds(all);
    for (const Threshold& threshold : defaults) {
        if (threshold.stress) chart.line({x.low, *threshold.stress}, {x.high, *threshold.stress}, threshold.stroke);
    }
    chart.line(s.volume, s.stress, volume_stroke);
    chart.line(s.lateral, s.stress, lateral_stroke);
    chart.line(s.axial, s.stress, axial_stroke);
    label_curves(chart, s, defaults, x);
    chart.legend(axial_stroke, "axial strain ε1");
    chart.legend(lateral_stroke, "lateral strain ε3");
    chart.legend(volume_stroke, "volumetric strain ε1 + 2 ε3");
    for (const Threshold& threshold : defaults) chart.legend(threshold.stroke, legend_of(threshold, s.stress[s.peak]));
    return chart.finish();
}

Drawing volume_chart(const Strains& s, const AllThresholds& all, const PictureStyle& whole) {
    PictureStyle style = whole.of_part(whole.page_width);
    style.x_limits.reset();
    style.y_limits.reset();
    // Bursting around the peak would compress the part of interest.
    const double axial = range_to_peak(s, s.axial).second;
    const double largest_volume = std::max(range_to_peak(s, s.volume).second, 0.1 * axial);
    const double smallest_volume = std::min(range_to_peak(s, s.volume).first, range_to_peak(s, s.cracks).first);
    const double low = std::clamp(1.1 * smallest_volume, -largest_volume, -0.1 * largest_volume);
    const double high = 1.15 * largest_volume;
    const Axis x{"axial strain by gauges, %", 0, 1.08 * axial};
    Chart chart(style, {}, x, Axis{"volumetric strain, %", low, high},
                {.height = 14 * std::sqrt(style.page_width), .min_left = left_edge});
    const auto defaults = default_thresholds(all);
    for (const Threshold& threshold : defaults) {
        if (!threshold.stress) continue;
        const double strain = at_stress(s, s.axial, *threshold.stress);
        chart.line({strain, low}, {strain, high}, threshold.stroke);
    }
    chart.line(s.axial, s.volume, volume_stroke, "volumetric strain");
    if (!s.cracks.empty()) chart.line(s.axial, s.cracks, crack_stroke, "crack volumetric strain: less the elastic line");
    const std::array read_from{&s.cracks, &s.volume};
    for (std::size_t i = 0; i < defaults.size(); ++i) {
        const Threshold& threshold = defaults[i];
        if (!threshold.stress) continue;
        chart.point({at_stress(s, s.axial, *threshold.stress), at_stress(s, *read_from[i], *threshold.stress)}, threshold.marker,
                    fmt::format("{}: {}", threshold.symbol, threshold.by));
    }
    return chart.finish();
}

}  // namespace

Drawing draw_thresholds(const RunData& run, const PictureStyle& style) {
    if (!is_compression(run.header)) {
        throw InputError(run.name + ": a " + run.header.test + " test; thresholds are read from uniaxial and triaxial ones");
    }
    const LoadCurve curve = load_curve(run);
    const Strains s = strains_of(curve);
    const AllThresholds all = measure_all_thresholds(run, curve, {});
    return stacked({stress_chart(run, s, all, style), volume_chart(s, all, style)});
}

}  // namespace graincrack
