// Draws strengths of several tests: as an envelope, and against grain size.
#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "post/fit/envelope.hpp"
#include "post/measure/strength.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

constexpr Colour interval{205, 214, 224};

struct Points {
    std::vector<double> x;
    std::vector<double> y;
    void add(double px, double py) {
        x.push_back(px);
        y.push_back(py);
    }
};

/// Draws a half circle over two principal stresses.
void draw_circle(Chart& chart, double low, double high, const Stroke& stroke) {
    Points points;
    constexpr int steps = 120;
    for (int i = 0; i <= steps; ++i) {
        const double angle = std::numbers::pi * i / steps;
        points.add(in_megapascals * ((low + high) / 2 - (high - low) / 2 * std::cos(angle)),
                   in_megapascals * (high - low) / 2 * std::sin(angle));
    }
    chart.line(points.x, points.y, stroke);
}

/// The part of the line above τ = 0, up to a normal stress.
Points line_of(const Envelope& envelope, double high) {
    const double tangent = std::tan(envelope.friction_angle.value);
    const double cohesion = envelope.cohesion.value * in_megapascals;
    const double low = tangent > 0 ? std::max(-cohesion / tangent, -high) : -high;
    Points points;
    for (const double normal : {low, high}) points.add(normal, cohesion + normal * tangent);
    return points;
}

/// The points at which the circles of the curve σ1(σ3) meet their envelope: σn = σ3 + (σ1 − σ3)/(s + 1), τ = (σn − σ3) √s, s =
/// dσ1/dσ3.
Points hull_of(const HoekBrown& fit, double largest) {
    Points points;
    const double lowest = -fit.tensile_strength();
    constexpr int steps = 200;
    for (int i = 1; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const double confining = lowest + (largest - lowest) * share * share;  // finer where the curve bends
        const double root = fit.strength(confining) - confining;
        const double slope = 1 + fit.mi.value * fit.sigma_ci.value / (2 * root);
        const double normal = confining + root / (slope + 1);
        points.add(normal * in_megapascals, (normal - confining) * std::sqrt(slope) * in_megapascals);
    }
    return points;
}

std::string envelope_label(const Estimate& e, double factor) {
    return fmt::format("{:.1f} [{:.1f}, {:.1f}]", e.value * factor, *e.low * factor, *e.high * factor);
}

std::string line_label(const Envelope& envelope, std::size_t tests) {
    const auto& c = envelope.cohesion;
    const auto& phi = envelope.friction_angle;
    if (!std::isfinite(c.value)) return "no Mohr–Coulomb line: the strength falls with the confining pressure";
    if (!envelope.is_determined()) return "C and φ: " + not_determined(tests);
    return fmt::format("C = {} MPa, φ = {}°, R² = {:.3f}", envelope_label(c, in_megapascals), envelope_label(phi, in_degrees),
                       envelope.line.r_squared);
}

/// The strength that is drawn, and the number of tests that have it.
std::string strength_label(const EnvelopeTests& tests) {
    std::string label = fmt::format("σ1 is the {} of a test", label_of(tests.kind));
    if (tests.compression.size() < tests.compression_runs) {
        label += fmt::format("; {} of {} tests have one", tests.compression.size(), tests.compression_runs);
    }
    return label;
}

Chart envelope_page(const EnvelopeTests& tests, const Envelope& envelope, const std::string& title, const PictureStyle& style) {
    double right = 0;
    double radius = 0;
    for (const auto& test : tests.compression) {
        right = std::max(right, test.strength * in_megapascals);
        radius = std::max(radius, (test.strength - test.confining) / 2 * in_megapascals);
    }
    double left = 0.06 * right;
    for (const auto* strengths : {&tests.brazilian, &tests.direct_tension}) {
        for (const double strength : *strengths) left = std::max(left, 1.3 * strength * in_megapascals);
    }
    std::vector<std::string> subtitle{line_label(envelope, tests.compression.size()), strength_label(tests)};
    if (tests.at_strain_limit > 0) {
        subtitle.push_back(fmt::format("{} of the tests stopped at the strain limit, without a peak", tests.at_strain_limit));
    }
    return {style, ChartText{title, subtitle}, Axis{"normal stress, MPa (compression positive)", -left, 1.03 * right},
            Axis{"shear stress, MPa", 0, 1.3 * radius}, ChartForm{.equal_scales = true}};
}

void draw_circles(Chart& chart, const EnvelopeTests& tests) {
    std::map<double, std::size_t> colours;
    for (const auto& test : tests.compression) colours.emplace(test.confining, 0);
    std::size_t next = 0;
    for (auto& [pressure, colour] : colours) {
        colour = next++;
        chart.legend(series_stroke(colour, 3), fmt::format("σ3 = {:.4g} MPa", pressure * in_megapascals));
    }
    for (const auto& test : tests.compression) {
        draw_circle(chart, test.confining, test.strength, series_stroke(colours.at(test.confining), 2.5));
    }
    const auto tensile = [&](const std::vector<double>& strengths, double high, const Stroke& stroke, const std::string& label) {
        for (const double strength : strengths) draw_circle(chart, -strength, high * strength, stroke);
        if (!strengths.empty()) chart.legend(stroke, label);
    };
    tensile(tests.brazilian, 3, Stroke{palette::rim, 2.5}, "Brazilian, centre of the disc");
    tensile(tests.direct_tension, 0, Stroke{palette::tensile, 2.5}, "direct tension");
}

}  // namespace

Drawing draw_envelope(const EnvelopeTests& tests, const std::string& title, const PictureStyle& style) {
    const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
    Chart chart = envelope_page(tests, envelope, title, style);
    draw_circles(chart, tests);
    const double right = largest(tests.strength()) * in_megapascals;
    if (std::isfinite(envelope.cohesion.value)) {
        const Points line = line_of(envelope, right);
        chart.line(line.x, line.y, {palette::ink, 4}, "Mohr–Coulomb");
    }
    if (envelope.hoek_brown) {
        const Points hull = hull_of(*envelope.hoek_brown, std::max(largest(tests.confining()), 0.1 * right / in_megapascals));
        const HoekBrown& fit = *envelope.hoek_brown;
        std::string values;
        if (determined(fit.mi)) {
            values = fmt::format(", σci {:.1f} MPa, mi {:.1f}", fit.sigma_ci.value * in_megapascals, fit.mi.value);
        }
        chart.line(hull.x, hull.y, {palette::ink, 3, Dash::dashed}, "Hoek–Brown" + values);
    }
    return chart.finish();
}

namespace {

/// A logarithmic axis over the values, with a tenth of a decade on both sides.
Axis logarithmic(const std::string& label, const std::vector<double>& values) {
    const auto [low, high] = padded_range(values, 0);
    return {label, low / 1.25, high * 1.25, true};
}

void draw_law(Chart& chart, double from, double to, double at_one, double exponent, const Stroke& stroke,
              const std::string& label) {
    const auto strength = [&](double edge) { return at_one * std::pow(edge, exponent); };
    chart.line({from, strength(from)}, {to, strength(to)}, stroke, label);
}

/// Draws the 95 % interval of the mean strength. \return false if there is none
bool draw_band(Chart& chart, const PowerLaw& law, double from, double to) {
    constexpr int steps = 100;
    std::vector<double> edge, low, high;
    for (int i = 0; i <= steps; ++i) {
        edge.push_back(from * std::pow(to / from, static_cast<double>(i) / steps));
        const Estimate mean = law.strength_at(edge.back() * 1e-3);
        if (!mean.low) return false;
        low.push_back(*mean.low * in_megapascals);
        high.push_back(*mean.high * in_megapascals);
    }
    chart.band(edge, low, high, interval);
    return true;
}

void draw_series(Chart& chart, const SizeSeries& s, std::size_t index) {
    const Colour colour = palette::series(index);
    const std::vector<double> edge = times(s.edge, 1e3);
    const std::string name = series_label(s.test, s.confining_pressure);
    const auto law = fit_power_law(s.edge, s.strength);
    const auto range = padded_range(edge, 0);
    const double low = range.first / 1.1;
    const double high = range.second * 1.1;
    const bool has_band = law && draw_band(chart, *law, low, high);
    chart.points(edge, times(s.strength, 1e-6), {colour, marker_shape(index)}, name);
    if (!law) return;
    if (has_band) chart.legend(interval, "95 % interval of the mean");
    std::string label = fmt::format("{}: n = {:.2f}", name, law->exponent.value);
    if (law->exponent.low) label += fmt::format(" [{:.2f}, {:.2f}]", *law->exponent.low, *law->exponent.high);
    draw_law(chart, low, high, law->coefficient * 1e-6, law->exponent.value, series_stroke(index), label);
    if (s.test != "brazilian" && s.test != "tension") return;
    // The slopes of theory and, for its rock, of the paper go through the middle of the points.
    double x = 0;
    double y = 0;
    for (std::size_t i = 0; i < edge.size(); ++i) {
        x += std::log(edge[i]) / static_cast<double>(edge.size());
        y += std::log(s.strength[i] * 1e-6) / static_cast<double>(edge.size());
    }
    const auto compare = [&](const std::string& who, double exponent, const Stroke& thin) {
        draw_law(chart, low, high, std::exp(y - exponent * x), exponent, thin, fmt::format("{}, n = {}", who, exponent));
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

}  // namespace graincrack
