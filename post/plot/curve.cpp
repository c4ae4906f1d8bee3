#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "post/cracks/crack_counts.hpp"
#include "post/measure/caveats.hpp"
#include "post/measure/strength.hpp"
#include "post/run/comparability.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

struct Run {
    const RunData* data;
    LoadCurve curve;
    std::vector<double> lateral;  ///< widening negative in compression, narrowing negative in tension
    std::optional<FirstPeak> first_peak;
    /// True if the largest stress is not the strength.
    [[nodiscard]] bool marks_largest() const { return !curve.strength || curve.exceeds_strength(); }
    [[nodiscard]] const char* peak_name() const { return first_peak ? "first peak" : "peak"; }
    [[nodiscard]] bool has_residual() const { return first_peak && first_peak->residual_strength(); }
};

std::string kind_of(const RunData& run) {
    return is_compression(run.header) ? "compression" : run.header.test + distinct_shape(run);
}

std::vector<Run> prepare(const std::vector<RunData>& data) {
    std::vector<Run> runs;
    for (const RunData& run : data) {
        if (kind_of(run) != kind_of(data.front())) {
            throw InputError(run.name + ": a " + run.header.test + " test cannot share a plot with " + data.front().name +
                             ", a " + data.front().header.test +
                             (run.header.test == data.front().header.test ? " test of another shape" : " test") +
                             "; plot them apart");
        }
        Run prepared{&run, load_curve(run), {}, {}};
        prepared.first_peak = measure_first_peak(run, prepared.curve);
        prepared.lateral = prepared.curve.lateral_strain;
        if (run.header.loading() != Loading::tension) {
            for (double& strain : prepared.lateral) strain = -strain;
        }
        runs.push_back(std::move(prepared));
    }
    return runs;
}

/// The common range of all curves, in the units of the axes.
struct Extent {
    double stress = 0;
    double strain = 0;
    double lateral = 0;
};

double max_cracks(const RunData& run) {
    return std::max(largest(run.history[HistoryColumn::tensile_cracks]), largest(run.history[HistoryColumn::shear_cracks]));
}

/// The strength as laboratories report it, and the largest stress if it differs.
std::string strength_label(const Run& run) {
    const LoadCurve& curve = run.curve;
    const auto label = [&](const std::string& name, double stress, std::size_t row) {
        return fmt::format("{} {:.4g} MPa at {:.3g} % strain", name, 1e-6 * stress, 100 * curve.axial_strain[row]);
    };
    const std::string largest = label("largest stress", curve.stress[curve.largest], curve.largest);
    if (!curve.strength) return std::string(did_not_fail) + ": " + largest;
    return label(run.peak_name(), curve.strength->stress, curve.peak) + (curve.exceeds_strength() ? "; " + largest : "");
}

/// The heading. \param title used for several runs
ChartText curve_heading(const std::vector<Run>& runs, const std::string& title, const std::string& definition) {
    const RunData& run = *runs[0].data;
    if (runs.size() > 1) return {title, {fmt::format("{} runs", runs.size())}};
    ChartText text{test_title(run.header),
                   {fmt::format("seed {}, {} crystals, mean diameter {:.3g} mm, plane {}", run.specimen.seed,
                                run.specimen.crystals, run.specimen.grain_diameter * 1e3, name_of(run.header.plane)),
                    strength_label(runs[0])}};
    if (!definition.empty()) text.notes.push_back(definition);
    return text;
}

/// Limit of the drawn lateral branches: boundaries that burst after the peak have strains that would compress everything else.
double drawn_lateral(const Extent& extent) { return std::max(extent.lateral, -0.75 * extent.strain); }

/// The page of a chart. \param definition definition of the cracks that are counted; empty if none are
Chart curve_page(const std::vector<Run>& runs, const std::string& title, const Extent& extent, const std::string& definition,
                 const std::vector<std::string>& caveats, const PictureStyle& style) {
    const double lateral = drawn_lateral(extent);
    const std::string stress = stress_name(*runs[0].data) + ", MPa";
    const std::string strain = lateral < -0.05 * extent.strain ? "strain, % (lateral left, axial right)" : "axial strain, %";
    std::optional<Axis> right;
    if (!definition.empty()) right = Axis{"micro-cracks (contacts)", 0, 1.1 * max_cracks(*runs[0].data)};
    ChartText text = curve_heading(runs, title, definition);
    text.notes.insert(text.notes.end(), caveats.begin(), caveats.end());
    return {style, text, Axis{strain, 1.1 * lateral, 1.05 * extent.strain}, Axis{stress, 0, 1.1 * extent.stress}, {right}};
}

constexpr Stroke shear_stroke{palette::shear, 4, Dash::dotted};
constexpr Stroke tensile_stroke{palette::tensile, 3, Dash::dashed};

/// Draws counts of cracks against axial strain on a separate scale at the right.
void draw_counts(Chart& chart, const Run& run) {
    const std::vector<double> strain = times(run.curve.axial_strain, 100);
    const History& history = run.data->history;
    chart.line(strain, from_first(history[HistoryColumn::shear_cracks]), shear_stroke, "", Chart::Side::right);
    chart.line(strain, from_first(history[HistoryColumn::tensile_cracks]), tensile_stroke, "", Chart::Side::right);
}

constexpr Marker largest_marker{palette::ink, MarkerShape::triangle, 13};
constexpr Marker leaves_marker{palette::ink, MarkerShape::leaves, 18};
constexpr Stroke residual_stroke{palette::rim, 5};

/// Draws the strength as a disc, a different largest stress as a triangle, and the residual strength as a line over the strains
/// of its mean.
void draw_strength(Chart& chart, const Run& run, const Colour& colour) {
    const auto mark = [&](double strain, double stress, const Marker& marker) {
        chart.point({100 * strain, 1e-6 * stress}, marker);
    };
    const LoadCurve& curve = run.curve;
    if (run.marks_largest()) mark(curve.axial_strain[curve.largest], curve.stress[curve.largest], largest_marker);
    if (curve.strength) mark(curve.axial_strain[curve.peak], curve.strength->stress, Marker{colour});
    if (run.has_residual()) {
        const auto at = [&](double beyond) {
            return std::array{100 * (run.first_peak->strain + beyond), 1e-6 * *run.first_peak->residual};
        };
        chart.line(at(residual_strains[0]), at(residual_strains[1]), residual_stroke);
    }
}

void draw_run(Chart& chart, const Run& run, std::size_t index) {
    const Colour colour = palette::series(index);
    const std::vector<double> stress = times(run.curve.stress, 1e-6);
    chart.line(times(run.lateral, 100), stress, series_stroke(index, 3));
    chart.line(times(run.curve.axial_strain, 100), stress, series_stroke(index, 4.5));
    draw_strength(chart, run, colour);
}

/// Draws arrows where lateral branches leave the frame, with their extent.
void mark_cut_branches(Chart& chart, const std::vector<Run>& runs, const Extent& extent, double left) {
    if (extent.lateral >= left) return;
    for (const Run& run : runs) {
        const std::vector<double> strain = times(run.lateral, 100);
        const auto out = std::find_if(strain.begin(), strain.end(), [left](double value) { return value < left; });
        if (out == strain.end() || out == strain.begin()) continue;
        const auto row = static_cast<std::size_t>(out - strain.begin());
        chart.point({left, 1e-6 * run.curve.stress[row]}, leaves_marker);
    }
    chart.legend(leaves_marker, fmt::format("lateral strain goes on, to −{:.3g} %", -extent.lateral));
}

std::string legend_label(const Run& run, const std::string& name) {
    const std::string peak = run.curve.strength ? run.peak_name() : std::string(did_not_fail) + ", largest stress";
    return fmt::format("{}: {} {:.4g} MPa", name, peak, 1e-6 * run.curve.peak_stress());
}

}  // namespace

Drawing draw_curves(const std::vector<RunData>& data, const std::string& definition, const std::vector<std::string>& caveats,
                    const PictureStyle& style) {
    const std::vector<Run> runs = prepare(data);
    Extent extent;
    for (const Run& run : runs) {
        extent.stress = std::max(extent.stress, 1e-6 * largest(run.curve.stress));
        extent.strain = std::max(extent.strain, 100 * largest(run.curve.axial_strain));
        extent.lateral = std::min(extent.lateral, 100 * smallest(run.lateral));
    }
    const bool counts = runs.size() == 1 && max_cracks(data.front()) > 0;
    Chart chart = curve_page(runs, common_material(data, "Stress and strain"), extent, counts ? definition : "", caveats, style);
    const std::vector<std::string> names = names_apart(data);
    if (counts) draw_counts(chart, runs[0]);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        draw_run(chart, runs[i], i);
        const std::string given = style.label_of(data[i].name);
        const std::string own = runs.size() == 1 ? "stress" : legend_label(runs[i], names[i]);
        chart.legend(series_stroke(i, 4.5), given.empty() ? own : given);
    }
    if (counts) {
        chart.legend(tensile_stroke, "tensile cracks, right");
        chart.legend(shear_stroke, "shear cracks, right");
    }
    if (std::any_of(runs.begin(), runs.end(), std::mem_fn(&Run::marks_largest))) {
        chart.legend(Marker{}, is_compression(data.front().header) ? "first peak" : "peak");
        chart.legend(largest_marker, "largest stress");
    }
    if (std::any_of(runs.begin(), runs.end(), std::mem_fn(&Run::has_residual))) {
        chart.legend(residual_stroke, "residual strength");
    }
    if (!style.x_limits) mark_cut_branches(chart, runs, extent, 1.1 * drawn_lateral(extent));
    return chart.finish();
}

}  // namespace graincrack
