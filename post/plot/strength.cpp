#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/chart/chart.hpp"
#include "post/measure/caveats.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/options/command.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

constexpr Colour interval{205, 214, 224};
const Marker peak{palette::series(0), MarkerShape::disc, 15};
const Marker no_peak{palette::series(1), MarkerShape::cross, 17};
const Stroke mean_stroke{palette::ink, 4};
const Stroke laboratory_stroke{palette::tensile, 3.5, Dash::dashed};
constexpr double half_width = 0.32;  ///< of what is drawn for a test, in distances between tests

std::optional<double> laboratory_of(const StrengthGroup& group, const std::optional<Material>& material) {
    const bool is_unconfined = test_named(group.test).loading == Loading::compression && group.confining_pressure == 0;
    const char* key = group.is_brazilian() ? "tensile_strength" : is_unconfined ? "compressive_strength" : "";
    const auto value = material ? material->laboratory_value(key) : std::nullopt;
    return value ? std::optional(*value * in_megapascals) : std::nullopt;
}

std::vector<double> all_values(const std::vector<RunData>& runs, const std::vector<StrengthGroup>& rows,
                               const std::optional<Material>& material) {
    std::vector<double> values;
    for (const RunData& run : runs) values.push_back(measure_strength(run).reported() * in_megapascals);
    for (const StrengthGroup& row : rows) {
        if (const auto value = laboratory_of(row, material)) values.push_back(*value);
    }
    return values;
}

/// Mean, interval, runs and laboratory of a test about its tick. \param lowest what the axis shows, MPa
void draw_row(Chart& chart, const std::vector<RunData>& runs, const StrengthGroup& row, double x,
              const std::optional<Material>& material, double lowest) {
    const Estimate& mean = row.strength.mean;
    const auto level = [&](double value, double half, const Stroke& stroke) {
        chart.line(std::vector<double>{x - half, x + half}, std::vector<double>(2, value), stroke);
    };
    // The interval of few runs may reach below zero, which a logarithmic axis cannot show.
    if (mean.low) {
        const double low = std::max(*mean.low * in_megapascals, lowest);
        chart.box(x - half_width, x + half_width, low, *mean.high * in_megapascals, interval);
    }
    if (row.runs.size() > 1) level(mean.value * in_megapascals, half_width, mean_stroke);
    if (const auto value = laboratory_of(row, material)) level(*value, 1.3 * half_width, laboratory_stroke);
    // Runs side by side in their order, symmetric about the tick.
    const double n = static_cast<double>(row.runs.size());
    for (std::size_t i = 0; i < row.runs.size(); ++i) {
        const Strength strength = measure_strength(runs[row.runs[i]]);
        const double at = x + 1.5 * half_width * ((static_cast<double>(i) + 0.5) / n - 0.5);
        chart.points(std::vector<double>{at}, std::vector<double>{strength.reported() * in_megapascals},
                     strength.has_peak() ? peak : no_peak);
    }
}

/// "plane stress: Brazilian", a line for each plane condition.
std::vector<std::string> plane_lines(const std::vector<StrengthGroup>& groups) {
    std::vector<std::string> lines;
    for (const PlaneCondition plane : {PlaneCondition::stress, PlaneCondition::strain}) {
        std::string tests;
        for (const StrengthGroup& group : groups) {
            if (group.plane != plane) continue;
            tests += (tests.empty() ? "" : ", ") + series_label(group.test, group.confining_pressure, group.shape);
        }
        if (!tests.empty()) lines.push_back(fmt::format("plane {}: {}", name_of(plane), tests));
    }
    return lines;
}

}  // namespace

Drawing draw_strengths(const std::vector<RunData>& runs, const std::optional<Material>& material,
                       const std::vector<std::string>& caveats, const PictureStyle& style) {
    const std::vector<StrengthGroup> rows = group_strengths_by_size(runs);
    const auto [low, high] = padded_range(all_values(runs, rows, material), 0);
    const Axis strength{"strength, MPa", low / 1.6, high * 1.6, true};
    Chart chart(style,
                {runs.front().header.material.empty() ? "Strengths" : runs.front().header.material,
                 plane_lines(group_strengths(runs)), caveats},
                Axis{"", 0.5, static_cast<double>(rows.size()) + 0.5}, strength);
    std::vector<std::pair<double, std::string>> names;
    std::size_t without_peak = 0;
    bool mean = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const StrengthGroup& group = rows[i];
        const double x = static_cast<double>(i) + 1;
        names.emplace_back(
            x, series_label(group.test, group.confining_pressure, group.shape) + (group.size.empty() ? "" : ",\n" + group.size));
        draw_row(chart, runs, group, x, material, strength.low);
        without_peak += group.without_peak;
        mean = mean || group.runs.size() > 1;
    }
    chart.name_ticks(names);
    if (without_peak < runs.size()) chart.legend(peak, "peak of a run");
    if (without_peak > 0) chart.legend(no_peak, "largest stress, no peak");
    if (mean) {
        chart.legend(mean_stroke, "mean");
        chart.legend(interval, "95 % interval");
    }
    if (material) chart.legend(laboratory_stroke, "laboratory");
    return chart.finish();
}

Command strength_plot() {
    struct Options : PlotOptions {
        std::string material;
    };
    return make_plot<Options>(
        "strength", "strengths by test with means and intervals, beside the laboratory's",
        {"uniaxial.h5 brazilian.h5 -o strength.png", "uniaxial.h5 brazilian.h5 --material augig-granite -o strength.svg"},
        several_runs,
        [](OptionSet set, Options& options) {
            add_picture(set, options);
            add_y_limits(set, options);
            add_laboratory_material(set, options.material);
        },
        [](const Options& options, const Call& call) {
            std::optional<Material> material;
            if (!options.material.empty()) material = read_material_of(call, options.material);
            CaveatCount doubts;
            const std::vector<RunData> runs = read_doubted_runs(call.files, doubts);
            return draw_strengths(runs, material, doubts.lines(), options.style);
        });
}

}  // namespace graincrack
