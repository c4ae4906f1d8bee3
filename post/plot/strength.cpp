#include "post/plot/strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/chart/chart.hpp"
#include "post/measure/objections.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/measure/test_label.hpp"
#include "post/plot/make_plot.hpp"

namespace graincrack {

namespace {

constexpr double mega = 1e-6;
const Marker peak{palette::series(0), MarkerShape::disc, 15};
const Marker no_peak{palette::series(1), MarkerShape::cross, 17};
const Marker measured{palette::ink, MarkerShape::square, 17};

std::optional<double> laboratory_of(const StrengthGroup& group, const std::optional<Material>& material) {
    const char* key = group.test == "brazilian" ? "tensile_strength" : group.test == "uniaxial" ? "compressive_strength" : "";
    if (!material || material->laboratory.count(key) == 0) return std::nullopt;
    return material->laboratory.at(key) * mega;
}

bool belongs(const RunData& run, const StrengthGroup& group) {
    return run.header.test == group.test && run.header.confining_pressure == group.confining_pressure;
}

std::vector<double> all_values(const std::vector<RunData>& runs, const std::vector<StrengthGroup>& groups,
                               const std::optional<Material>& material) {
    std::vector<double> values;
    for (const RunData& run : runs) values.push_back(measure_strength(run).value() * mega);
    for (const StrengthGroup& group : groups) {
        if (const auto value = laboratory_of(group, material)) values.push_back(*value);
    }
    return values;
}

void draw_group(Chart& chart, const std::vector<RunData>& runs, const StrengthGroup& group, double x,
                const std::optional<Material>& material) {
    const auto dot = [&](double at, double value, const Marker& marker) {
        chart.points(std::vector<double>{at}, std::vector<double>{value}, marker);
    };
    const Estimate& mean = group.strength.mean;
    // The interval of few runs may reach below zero, which a logarithmic axis cannot show.
    if (mean.low) chart.error_bar(x + 0.12, std::max(*mean.low, 0.01 * mean.value) * mega, *mean.high * mega, palette::rim);
    chart.line(std::vector<double>{x - 0.1, x + 0.2}, std::vector<double>(2, mean.value * mega), Stroke{palette::rim, 4});
    for (const RunData& run : runs) {
        if (!belongs(run, group)) continue;
        const Strength strength = measure_strength(run);
        dot(x - 0.05, strength.value() * mega, strength.peak_kind == "drop" ? peak : no_peak);
    }
    if (const auto value = laboratory_of(group, material)) dot(x - 0.25, *value, measured);
}

/// "plane stress: Brazilian", a line for each plane condition.
std::vector<std::string> plane_lines(const std::vector<StrengthGroup>& groups) {
    std::vector<std::string> lines;
    for (const PlaneCondition plane : {PlaneCondition::stress, PlaneCondition::strain}) {
        std::string tests;
        for (const StrengthGroup& group : groups) {
            if (group.plane != plane) continue;
            tests += (tests.empty() ? "" : ", ") + series_label(group.test, group.confining_pressure);
        }
        if (!tests.empty()) lines.push_back(fmt::format("plane {}: {}", name_of(plane), tests));
    }
    return lines;
}

}  // namespace

Drawing draw_strengths(const std::vector<RunData>& runs, const std::optional<Material>& material,
                       const std::vector<std::string>& objections) {
    const std::vector<StrengthGroup> groups = group_strengths(runs);
    std::vector<std::string> subtitle = plane_lines(groups);
    for (const std::string& objection : objections) {  // a long one in two lines
        const std::size_t part = objection.find("; ");
        subtitle.push_back(objection.substr(0, part == std::string::npos ? part : part + 1));
        if (part != std::string::npos) subtitle.push_back(objection.substr(part + 2));
    }
    const auto [low, high] = padded_range(all_values(runs, groups, material), 0);
    const double n = static_cast<double>(groups.size());
    Chart chart({runs.front().header.material.empty() ? "Strengths" : runs.front().header.material, subtitle},
                Axis{"", 0.5, n + 0.5}, Axis{"strength, MPa", low / 1.6, high * 1.6, true});
    std::vector<std::pair<double, std::string>> names;
    std::size_t without_peak = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const double x = static_cast<double>(i) + 1;
        names.emplace_back(x, series_label(groups[i].test, groups[i].confining_pressure));
        draw_group(chart, runs, groups[i], x, material);
        without_peak += groups[i].without_peak;
    }
    chart.name_ticks(names);
    chart.legend(peak, "peak of a run");
    if (without_peak > 0) chart.legend(no_peak, "largest stress, no peak");
    chart.legend(Stroke{palette::rim, 4}, "mean, 95 % interval");
    if (material) chart.legend(measured, "laboratory");
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
        [](CLI::App& app, Options& options) {
            add_picture(app, options);
            add_laboratory_material(app, options.material);
        },
        [](const Options& options, const Call& call) {
            std::optional<Material> material;
            if (!options.material.empty()) material = read_material(options.material);
            ObjectionCount doubts;
            const std::vector<RunData> runs = read_doubted_runs(call.files, doubts);
            return draw_strengths(runs, material, doubts.lines());
        });
}

}  // namespace graincrack
