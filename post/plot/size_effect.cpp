#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <cmath>

#include "post/chart/chart.hpp"
#include "post/chart/numbers.hpp"
#include "post/fit/fit_options.hpp"
#include "post/run/test_label.hpp"

namespace graincrack {

namespace {

/// The range of the values with a tenth of a decade on both sides.
Axis logarithmic(const std::string& label, const std::vector<double>& values) {
    const auto [low, high] = padded_range(values, 0);
    return {label, low / 1.25, high * 1.25, true};
}

void draw_law(Chart& chart, double from, double to, double at_one, double exponent, const Stroke& stroke) {
    const auto strength = [&](double edge) { return at_one * std::pow(edge, exponent); };
    chart.line(std::vector<double>{from, to}, std::vector<double>{strength(from), strength(to)}, stroke);
}

void draw_series(Chart& chart, const SizeSeries& s, std::size_t index) {
    const Colour colour = palette::series(index);
    const std::vector<double> edge = times(s.edge, 1e3);
    const Marker marker{colour, marker_shape(index)};
    chart.points(edge, times(s.strength, 1e-6), marker);
    const std::string name = series_label(s.test, s.confining_pressure);
    const auto law = fit_power_law_log(s.edge, s.strength);
    chart.legend(marker, name);
    if (!law) return;
    const auto range = padded_range(edge, 0);
    const double low = range.first / 1.1;
    const double high = range.second * 1.1;
    const Stroke stroke = series_stroke(index);
    draw_law(chart, low, high, law->coefficient * 1e-6, law->exponent.value, stroke);
    std::string label = fmt::format("n = {:.2f}", law->exponent.value);
    if (law->exponent.low) label += fmt::format(" [{:.2f}, {:.2f}]", *law->exponent.low, *law->exponent.high);
    chart.legend(stroke, name + ": " + label);
    if (s.test != "brazilian" && s.test != "tension") return;
    // The slopes of theory and, for its rock, of the paper through the middle of the points.
    double x = 0;
    double y = 0;
    for (std::size_t i = 0; i < edge.size(); ++i) {
        x += std::log(edge[i]) / static_cast<double>(edge.size());
        y += std::log(s.strength[i] * 1e-6) / static_cast<double>(edge.size());
    }
    const auto compare = [&](const std::string& who, double exponent, const Stroke& thin) {
        draw_law(chart, low, high, std::exp(y - exponent * x), exponent, thin);
        chart.legend(thin, fmt::format("{}, n = {}", who, exponent));
    };
    compare("theory", theory_exponent, Stroke{colour, 4, Dash::dotted});
    if (const auto exponent = s.exponent_of_paper()) {
        compare("Kazerani & Zhao (2014)", *exponent, Stroke{palette::rim, 2.5, Dash::long_dashed});
    }
}

}  // namespace

Drawing draw_size_effect(const std::vector<SizeSeries>& series, const PictureStyle& style) {
    std::vector<double> edges;
    std::vector<double> strengths;
    std::size_t at_strain_limit = 0;
    for (const SizeSeries& s : series) {
        for (const double edge : s.edge) edges.push_back(edge * 1e3);
        for (const double strength : s.strength) strengths.push_back(strength * 1e-6);
        at_strain_limit += s.at_strain_limit;
    }
    std::vector<std::string> subtitle{"strength ∝ (mean edge)ⁿ by logarithms, 95 % interval of n"};
    if (at_strain_limit > 0) {
        subtitle.push_back(fmt::format("{} of the runs stopped at the strain limit, without a peak", at_strain_limit));
    }
    Chart chart(style, {"Size effect", subtitle}, logarithmic("mean edge, mm", edges), logarithmic("strength, MPa", strengths));
    for (std::size_t i = 0; i < series.size(); ++i) draw_series(chart, series[i], i);
    return chart.finish();
}

Command size_effect_plot() {
    struct Options : PlotOptions {
        StrainLimitRuns strain_limit_runs = StrainLimitRuns::refuse;
    };
    return make_plot<Options>(
        "size-effect", "strength against mean edge with the power law",
        {"brazilian-coarse.h5 brazilian.h5 -o size.png", "brazilian-coarse.h5 brazilian.h5 --capped accept -o size.svg"},
        several_runs,
        [](OptionSet set, Options& options) {
            add_chart(set, options);
            add_strain_limit_runs(set, options.strain_limit_runs);
        },
        [](const Options& options, const Call& call) {
            return draw_size_effect(collect_sizes(read_runs(call.files), options.strain_limit_runs), options.style);
        });
}

}  // namespace graincrack
