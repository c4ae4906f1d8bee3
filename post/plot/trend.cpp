#include "post/plot/trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "post/chart/chart.hpp"
#include "post/chart/labels.hpp"
#include "post/fit/fit_options.hpp"
#include "post/plot/make_plot.hpp"

namespace graincrack {

namespace {

std::vector<double> all_of(const std::vector<TrendRows>& groups, std::vector<double> TrendRows::*column) {
    std::vector<double> all;
    for (const TrendRows& g : groups) all.insert(all.end(), (g.*column).begin(), (g.*column).end());
    return all;
}

Axis trend_axis(const std::vector<double>& values, const std::string& label, bool logarithmic) {
    const auto [low, high] = padded_range(values, 0.08);
    if (!logarithmic) return {label, low, high};
    const auto [least, most] = padded_range(values, 0);
    return {label, least / 1.15, most * 1.15, true};
}

std::string trend_label(const std::string& name, const Estimate& e) {
    std::string label = fmt::format("{} = {:.3g}", name, e.value);
    if (e.low && e.high) label += fmt::format(" [{:.3g}, {:.3g}]", *e.low, *e.high);
    return label;
}

/// A fitted line and the bounds of its mean over the range of its group; no bounds where the rows are too few for them.
struct FitCurve {
    std::vector<double> x;
    std::vector<double> value;
    std::vector<double> low;
    std::vector<double> high;
    [[nodiscard]] bool has_band() const { return !low.empty() && std::isfinite(low.front()); }
};

FitCurve curve_of(const TrendRows& rows, const Trend& trend) {
    constexpr int steps = 60;
    const auto [low, high] = std::minmax_element(rows.x.begin(), rows.x.end());
    FitCurve curve;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        curve.x.push_back(trend.power ? *low * std::pow(*high / *low, share) : *low + share * (*high - *low));
        const Estimate e = trend.at(curve.x.back());
        curve.value.push_back(e.value);
        curve.low.push_back(e.low.value_or(std::nan("")));
        curve.high.push_back(e.high.value_or(std::nan("")));
    }
    return curve;
}

/// The rows of a group with what was fitted to them.
struct FittedRows {
    const TrendRows& rows;
    std::optional<Trend> trend;
    FitCurve curve;
};

std::vector<FittedRows> fit_groups(const std::vector<TrendRows>& groups, bool power) {
    std::vector<FittedRows> fitted;
    for (const TrendRows& rows : groups) {
        if (rows.x.empty()) continue;
        const auto trend = fit_trend(rows.x, rows.y, power);
        fitted.push_back({rows, trend, trend ? curve_of(rows, *trend) : FitCurve{}});
    }
    return fitted;
}

Colour pale(Colour colour) {
    const auto part = [](std::uint8_t value) { return static_cast<std::uint8_t>(255 - (255 - value) / 6); };
    return {part(colour.red), part(colour.green), part(colour.blue)};
}

}  // namespace

Drawing draw_trend(const std::vector<TrendRows>& groups, const TrendOptions& options, const PictureStyle& style) {
    const std::string what = options.power ? "y = a xᵇ through logarithms" : "y = a + b x by least squares";
    const std::vector<FittedRows> fitted = fit_groups(groups, options.power);
    std::vector<double> y = all_of(groups, &TrendRows::y);
    for (const FittedRows& each : fitted) {  // no band is cut by the frame
        y.insert(y.end(), each.curve.low.begin(), each.curve.low.end());
        y.insert(y.end(), each.curve.high.begin(), each.curve.high.end());
    }
    Chart chart(style, {"", {what + "; bands: 95 % interval of the mean"}},
                trend_axis(all_of(groups, &TrendRows::x), column_label(options.x), options.power),
                trend_axis(y, column_label(options.y), options.power));
    for (std::size_t i = 0; i < fitted.size(); ++i) {
        const FitCurve& curve = fitted[i].curve;
        if (curve.has_band()) chart.band(curve.x, curve.low, curve.high, pale(palette::series(i)));
    }
    for (std::size_t i = 0; i < fitted.size(); ++i) {
        const auto& [rows, trend, curve] = fitted[i];
        const Stroke stroke = series_stroke(i);
        const Marker marker{stroke.colour, marker_shape(i)};
        for (const auto* bound : {&curve.low, &curve.high}) chart.line(curve.x, *bound, Stroke{stroke.colour, 1.6, stroke.dash});
        chart.line(curve.x, curve.value, stroke);
        chart.points(rows.x, rows.y, marker);
        std::string label = rows.group.empty() ? "" : rows.group + ": ";
        label += trend ? trend_label("b", trend->slope) + fmt::format(", R² = {:.3f}", trend->line.r_squared)
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
        [](OptionSet set, Options& options) {
            add_trend(set, options.trend);
            add_chart(set, options);
        },
        [](const Options& options, const Call& call) {
            return draw_trend(collect_trends(call.files, options.trend, call.diagnostics()), options.trend, options.style);
        });
}

}  // namespace graincrack
