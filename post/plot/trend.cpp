#include "post/plot/trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/chart/chart.hpp"
#include "post/chart/labels.hpp"
#include "post/plot/make_plot.hpp"

namespace graincrack {

namespace {

std::vector<double> all_of(const std::vector<TrendRows>& groups, std::vector<double> TrendRows::*column) {
    std::vector<double> all;
    for (const TrendRows& g : groups) all.insert(all.end(), (g.*column).begin(), (g.*column).end());
    return all;
}

Axis axis_over(const std::vector<double>& values, const std::string& label, bool logarithmic) {
    const auto [low, high] = padded_range(values, 0.08);
    if (!logarithmic) return {label, low, high};
    const auto [least, most] = padded_range(values, 0);
    return {label, least / 1.15, most * 1.15, true};
}

std::string interval_label(const std::string& name, const Estimate& e) {
    std::string label = fmt::format("{} = {:.3g}", name, e.value);
    if (e.low && e.high) label += fmt::format(" [{:.3g}, {:.3g}]", *e.low, *e.high);
    return label;
}

/// The line and the bounds of its mean, over the range of the group.
void draw_fit(Chart& chart, const TrendRows& rows, const Trend& trend, const Stroke& stroke) {
    constexpr int steps = 60;
    const auto [low, high] = std::minmax_element(rows.x.begin(), rows.x.end());
    std::vector<double> x;
    std::vector<std::vector<double>> y(3);
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        x.push_back(trend.power ? *low * std::pow(*high / *low, share) : *low + share * (*high - *low));
        const Estimate e = trend.at(x.back());
        y[0].push_back(e.value);
        y[1].push_back(e.low.value_or(std::nan("")));
        y[2].push_back(e.high.value_or(std::nan("")));
    }
    chart.line(x, y[0], stroke);
    for (const auto& bound : {y[1], y[2]}) chart.line(x, bound, Stroke{stroke.colour, 1.6, stroke.dash});
}

}  // namespace

Drawing draw_trend(const std::vector<TrendRows>& groups, const TrendOptions& options, const PictureStyle& style) {
    const std::string what = options.power ? "y = a xᵇ through logarithms" : "y = a + b x by least squares";
    Chart chart(style, {"", {what + "; thin: 95 % interval of the mean"}},
                axis_over(all_of(groups, &TrendRows::x), column_label(options.x), options.power),
                axis_over(all_of(groups, &TrendRows::y), column_label(options.y), options.power));
    std::size_t drawn = 0;
    for (const TrendRows& rows : groups) {
        if (rows.x.empty()) continue;
        const Colour colour = palette::series(drawn);
        const Marker marker{colour, marker_shape(drawn)};
        const Stroke stroke = series_stroke(drawn);
        ++drawn;
        const auto trend = fit_trend(rows.x, rows.y, options.power);
        if (trend) draw_fit(chart, rows, *trend, stroke);
        chart.points(rows.x, rows.y, marker);
        std::string label = rows.group.empty() ? "" : rows.group + ": ";
        label += trend ? interval_label("b", trend->slope) + fmt::format(", R² = {:.3f}", trend->line.r_squared)
                       : fmt::format("{} rows at one x", rows.x.size());
        chart.legend(marker, label);
    }
    return chart.finish();
}

Command trend_plot() {
    struct Options : PlotOptions {
        TrendOptions trend;
    };
    return make_plot<Options>(
        "trend", "columns of tables with the line or power law through them",
        {"strength.tsv --x mean_edge_mm --y tensile_strength_MPa --power -o trend.png",
         "strength.tsv --x contact_cohesion_MPa --y peak_compressive_stress_MPa --group test -o trend.svg"},
        trend_tables,
        [](CLI::App& app, Options& options) {
            add_trend(app, options.trend);
            add_chart(app, options);
        },
        [](const Options& options, const Call& call) {
            return draw_trend(collect_trends(call.files, options.trend, call.diagnostics()), options.trend, options.style);
        });
}

}  // namespace graincrack
