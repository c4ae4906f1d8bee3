#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "post/chart/chart.hpp"
#include "post/chart/numbers.hpp"
#include "post/fit/fit_options.hpp"
#include "post/options/command.hpp"
#include "post/table/column.hpp"
#include "share/base/table_file.hpp"

namespace graincrack {

namespace {

struct Points {
    std::vector<double> x;
    std::vector<double> y;
    void add(double px, double py) {
        x.push_back(px);
        y.push_back(py);
    }
};

/// Half circle over two principal stresses, in MPa.
Points circle(double low, double high) {
    Points points;
    constexpr int steps = 120;
    for (int i = 0; i <= steps; ++i) {
        const double angle = std::numbers::pi * i / steps;
        points.add(in_megapascals * ((low + high) / 2 - (high - low) / 2 * std::cos(angle)),
                   in_megapascals * (high - low) / 2 * std::sin(angle));
    }
    return points;
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

/// The points at which the circles of the curve σ1(σ3) touch their envelope: σn = σ3 + (σ1 − σ3)/(s + 1), τ = (σn − σ3) √s, s =
/// dσ1/dσ3.
Points hull_of(const HoekBrown& fit, double largest) {
    Points points;
    const double lowest = -fit.tensile_strength();
    constexpr int steps = 200;
    for (int i = 1; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const double confining = lowest + (largest - lowest) * share * share;  // finer where it bends
        const double root = fit.strength(confining) - confining;
        const double slope = 1 + fit.mi.value * fit.sigma_ci.value / (2 * root);
        const double normal = confining + root / (slope + 1);
        points.add(normal * in_megapascals, (normal - confining) * std::sqrt(slope) * in_megapascals);
    }
    return points;
}

double largest_confining(const EnvelopeTests& tests) {
    double largest = 0;
    for (const auto& test : tests.compression) largest = std::max(largest, test.confining);
    return largest;
}

std::string envelope_label(const Estimate& e, double factor) {
    return e.low ? fmt::format(" [{:.1f}, {:.1f}]", *e.low * factor, *e.high * factor) : std::string();
}

std::string line_label(const Envelope& envelope) {
    const auto& c = envelope.cohesion;
    const auto& phi = envelope.friction_angle;
    if (!std::isfinite(c.value)) return "no Mohr–Coulomb line: the strength falls with the confining pressure";
    return fmt::format("C = {:.1f}{} MPa, φ = {:.1f}{}°, R² = {:.3f}", c.value * in_megapascals,
                       envelope_label(c, in_megapascals), phi.value * in_degrees, envelope_label(phi, in_degrees),
                       envelope.line.r_squared);
}

/// Which stress of the tests is drawn, and how many of them have it.
std::string strength_label(const EnvelopeTests& tests) {
    const char* stress = tests.kind == StrengthKind::first_peak ? "first peak"
                         : tests.kind == StrengthKind::residual ? "residual strength"
                                                                : "largest stress";
    std::string label = fmt::format("σ1 is the {} of a test", stress);
    if (!tests.left_out.empty()) {
        label += fmt::format("; {} of {} tests have one", tests.compression.size(), tests.compression_runs());
    }
    return label;
}

Chart envelope_page(const EnvelopeTests& tests, const Envelope& envelope, const std::string& title,
                    const std::vector<LaboratoryStrengths>& laboratory, const PictureStyle& style) {
    double right = 0;
    double radius = 0;
    const auto include = [&](double confining, double strength) {
        right = std::max(right, strength * in_megapascals);
        radius = std::max(radius, (strength - confining) / 2 * in_megapascals);
    };
    for (const auto& test : tests.compression) include(test.confining, test.strength);
    for (const auto& set : laboratory) {
        for (std::size_t i = 0; i < set.strength.size(); ++i) include(set.confining[i], set.strength[i]);
    }
    double left = 0.06 * right;
    for (const auto* strengths : {&tests.brazilian, &tests.direct_tension}) {
        for (const double strength : *strengths) left = std::max(left, 1.3 * strength * in_megapascals);
    }
    std::vector<std::string> subtitle{line_label(envelope), strength_label(tests)};
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
        const Points points = circle(test.confining, test.strength);
        chart.line(points.x, points.y, series_stroke(colours.at(test.confining), 2.5));
    }
    const auto tensile = [&](const std::vector<double>& strengths, double high, const Stroke& stroke, const std::string& label) {
        for (const double strength : strengths) {
            const Points points = circle(-strength, high * strength);
            chart.line(points.x, points.y, stroke);
        }
        if (!strengths.empty()) chart.legend(stroke, label);
    };
    tensile(tests.brazilian, 3, Stroke{palette::rim, 2.5}, "Brazilian, centre of the disc");
    tensile(tests.direct_tension, 0, Stroke{palette::tensile, 2.5}, "direct tension");
}

void draw_laboratory_strengths(Chart& chart, const std::vector<LaboratoryStrengths>& laboratory) {
    for (const auto& set : laboratory) {
        const Stroke stroke{palette::rim, 3.5, Dash::dotted};
        for (std::size_t i = 0; i < set.strength.size(); ++i) {
            const Points points = circle(set.confining[i], set.strength[i]);
            chart.line(points.x, points.y, stroke);
        }
        chart.legend(stroke, "laboratory: " + set.name);
    }
}

}  // namespace

LaboratoryStrengths read_laboratory_strengths(const std::string& path) {
    const TableFile table(path);
    return {std::filesystem::path(table.name()).filename().string(), times(table.numbers("confining_pressure_MPa"), 1e6),
            times(table.numbers("strength_MPa"), 1e6)};
}

Drawing draw_envelope(const EnvelopeTests& tests, const std::string& title, const std::vector<LaboratoryStrengths>& laboratory,
                      const PictureStyle& style) {
    const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
    Chart chart = envelope_page(tests, envelope, title, laboratory, style);
    draw_circles(chart, tests);
    draw_laboratory_strengths(chart, laboratory);
    double right = 0;
    for (const auto& test : tests.compression) right = std::max(right, test.strength * in_megapascals);
    if (std::isfinite(envelope.cohesion.value)) {
        const Points line = line_of(envelope, right);
        chart.line(line.x, line.y, Stroke{palette::ink, 4});
        chart.legend(Stroke{palette::ink, 4}, "Mohr–Coulomb");
    }
    if (envelope.hoek_brown) {
        const Points hull = hull_of(*envelope.hoek_brown, std::max(largest_confining(tests), 0.1 * right / in_megapascals));
        chart.line(hull.x, hull.y, Stroke{palette::ink, 3, Dash::dashed});
        chart.legend(Stroke{palette::ink, 3, Dash::dashed},
                     fmt::format("Hoek–Brown, σci {:.1f} MPa, mi {:.1f}", envelope.hoek_brown->sigma_ci.value * in_megapascals,
                                 envelope.hoek_brown->mi.value));
    }
    return chart.finish();
}

Command envelope_plot() {
    struct Options : PlotOptions {
        EnvelopeOptions envelope;
        std::vector<std::string> laboratory;  ///< tables of measured strengths
    };
    return make_plot<Options>(
        "envelope", "Mohr circles, Mohr-Coulomb and Hoek-Brown envelopes",
        {"uniaxial.h5 triaxial.h5 -o envelope.png",
         "uniaxial.h5 triaxial.h5 brazilian.h5 --strength largest --capped accept -o envelope.svg"},
        several_runs,
        [](OptionSet set, Options& options) {
            add_chart(set, options);
            add_envelope_options(set, options.envelope);
            add_texts(set, "--laboratory", options.laboratory, "FILE",
                      "table of measured strengths: confining_pressure_MPa, strength_MPa");
        },
        [](const Options& options, const Call& call) {
            const std::vector<RunData> runs = read_runs(call.files);
            std::vector<LaboratoryStrengths> laboratory;
            for (const std::string& file : options.laboratory) laboratory.push_back(read_laboratory_strengths(file));
            const EnvelopeTests tests = collect_envelope_tests(runs, options.envelope);
            print_left_out(call.diagnostics(), tests);
            return draw_envelope(tests, runs.front().header.material, laboratory, options.style);
        });
}

}  // namespace graincrack
