#include "post/plot/thresholds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/chart/chart.hpp"
#include "post/chart/numbers.hpp"
#include "post/measure/thresholds.hpp"
#include "post/plot/make_plot.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

/// Axial and volumetric strains in % up to just past the peak.
struct Strains {
    std::vector<double> axial;
    std::vector<double> plane;
    std::vector<double> pseudo_3d;
    std::vector<double> stress;  ///< MPa
};

Strains strains_of(const LoadCurve& curve) {
    Strains s;
    const double last = 1.15 * curve.gauge_axial_strain[curve.peak];
    for (std::size_t i = curve.start; i < curve.stress.size() && curve.gauge_axial_strain[i] <= last; ++i) {
        const double axial = curve.gauge_axial_strain[i] - curve.gauge_axial_strain[curve.start];
        const double lateral = curve.gauge_lateral_strain[i] - curve.gauge_lateral_strain[curve.start];
        s.axial.push_back(100 * axial);
        s.plane.push_back(100 * (axial - lateral));
        s.pseudo_3d.push_back(100 * (axial - 2 * lateral));
        s.stress.push_back(1e-6 * curve.stress[i]);
    }
    return s;
}

/// The gauge strain at which a stress is first reached, between two rows.
double strain_at(const Strains& s, double stress) {
    const auto at = std::find_if(s.stress.begin(), s.stress.end(), [&](double v) { return v >= stress; });
    if (at == s.stress.end()) return s.axial.back();
    const auto row = static_cast<std::size_t>(at - s.stress.begin());
    if (row == 0) return s.axial[0];
    const double share = (stress - s.stress[row - 1]) / (s.stress[row] - s.stress[row - 1]);
    return s.axial[row - 1] + share * (s.axial[row] - s.axial[row - 1]);
}

struct Mark {
    const char* label;
    std::optional<double> stress;  ///< Pa
    Marker marker;
};

std::vector<Mark> marks_of(const RunData& run, const LoadCurve& curve) {
    const Thresholds plane = measure_thresholds(curve, VolumeKind::plane);
    const Thresholds pseudo = measure_thresholds(curve, VolumeKind::pseudo_3d);
    const Colour two = palette::series(1);
    const Colour three = palette::series(2);
    const auto hollow = [](Colour colour, MarkerShape shape) { return Marker{colour, shape, 26, true}; };
    return {{"initiation, crack count", initiation_by_count(run, curve), hollow(palette::tensile, MarkerShape::triangle)},
            {"initiation, crack strain 2D", plane.initiation_by_crack_strain, hollow(two, MarkerShape::disc)},
            {"initiation, crack strain pseudo-3D", pseudo.initiation_by_crack_strain, hollow(three, MarkerShape::diamond)},
            {"initiation, lateral response pseudo-3D", pseudo.initiation_by_lateral_response, {three, MarkerShape::cross, 20}},
            {"damage 2D", plane.damage, hollow(two, MarkerShape::square)},
            {"damage pseudo-3D", pseudo.damage, hollow(three, MarkerShape::leaves)}};
}

/// The frames of both charts begin at one place.
constexpr double left_edge = 140;

Drawing stress_chart(const RunData& run, const LoadCurve& curve, const Strains& s, const Axis& x, const PictureStyle& style) {
    Chart chart(style,
                {test_title(run.header),
                 {"plane " + std::string(name_of(run.header.plane)) + ": 2D values do not compare with laboratory ones"}},
                x, Axis{"stress, MPa", 0, 1.1 * largest(s.stress)}, {.min_left = left_edge});
    const Stroke load{palette::series(0), 4.5};
    chart.line(s.axial, s.stress, load);
    for (const Mark& mark : marks_of(run, curve)) {
        if (!mark.stress) continue;
        const double stress = *mark.stress * 1e-6;
        chart.points(std::vector<double>{strain_at(s, stress)}, std::vector<double>{stress}, mark.marker);
        chart.legend(mark.marker, fmt::format("{}: {:.1f} MPa", mark.label, stress));
    }
    return chart.finish();
}

Drawing volume_chart(const Strains& s, const Axis& x, PictureStyle style) {
    style = style.of_part(style.page_width);
    style.y_limits.reset();
    std::vector<double> volumes = s.plane;
    volumes.insert(volumes.end(), s.pseudo_3d.begin(), s.pseudo_3d.end());
    const auto [low, high] = padded_range(volumes, 0.05);
    const double floor = std::max(low, -0.4 * high);  // bursting after the peak would compress the part of interest
    Chart chart(style, {}, x, Axis{"volumetric strain, %", floor, high},
                {.height = 11 * std::sqrt(style.page_width), .min_left = left_edge});
    const Stroke plane{palette::series(1), 3.5};
    const Stroke pseudo{palette::series(2), 3.5, Dash::dashed};
    chart.line(s.axial, s.plane, plane);
    chart.line(s.axial, s.pseudo_3d, pseudo);
    chart.legend(plane, "ε1 + ε3 (2D)");
    chart.legend(pseudo, "ε1 + 2ε3 (pseudo-3D)");
    return chart.finish();
}

}  // namespace

Drawing draw_thresholds(const RunData& run, const PictureStyle& style) {
    if (!is_compression(run.header)) {
        throw InputError(run.name + ": a " + run.header.test + " test; thresholds are read from uniaxial and triaxial ones");
    }
    const LoadCurve curve = load_curve(run);
    const Strains s = strains_of(curve);
    const Axis x{"axial strain (gauge), %", 0, 1.03 * largest(s.axial)};
    return stacked({stress_chart(run, curve, s, x, style), volume_chart(s, x, style)});
}

Command thresholds_plot() {
    return make_plot<PlotOptions>(
        "thresholds", "crack initiation and damage on stress and volumetric strain",
        {"uniaxial.h5 -o thresholds.png", "triaxial.h5 -o thresholds.svg"}, one_run, add_chart,
        [](const PlotOptions& options, const Call& call) { return draw_thresholds(read_run_data(call.file()), options.style); });
}

}  // namespace graincrack
