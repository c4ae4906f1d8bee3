#include "post/picture/plot_envelope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "post/picture/chart.hpp"

namespace graincrack {

namespace {

constexpr double mega = 1e-6;
constexpr double degrees = 180 / std::numbers::pi;

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
        points.add(mega * ((low + high) / 2 - (high - low) / 2 * std::cos(angle)), mega * (high - low) / 2 * std::sin(angle));
    }
    return points;
}

Points line_of(const Envelope& envelope, double high) {
    const double tangent = std::tan(envelope.friction_angle.value);
    const double cohesion = envelope.cohesion.value * mega;
    Points points;
    points.add(-cohesion / tangent, 0);
    points.add(high, cohesion + high * tangent);
    return points;
}

/// Where the circles of the curve σ1(σ3) touch their hull: σn = σ3 + (σ1 − σ3)/(s + 1), τ = (σn − σ3) √s, s = dσ1/dσ3.
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
        points.add(normal * mega, (normal - confining) * std::sqrt(slope) * mega);
    }
    return points;
}

double largest_confining(const EnvelopeTests& tests) {
    double largest = 0;
    for (const auto& test : tests.compression) largest = std::max(largest, test.confining);
    return largest;
}

Chart page(const EnvelopeTests& tests, const Envelope& envelope, const std::string& title) {
    double right = 0;
    double radius = 0;
    for (const auto& test : tests.compression) {
        right = std::max(right, test.strength * mega);
        radius = std::max(radius, (test.strength - test.confining) / 2 * mega);
    }
    double left = 0.06 * right;
    for (const auto* strengths : {&tests.brazilian, &tests.direct_tension}) {
        for (const double strength : *strengths) left = std::max(left, 1.3 * strength * mega);
    }
    const auto& c = envelope.cohesion;
    const auto& phi = envelope.friction_angle;
    const auto interval = [](const Estimate& e, double factor) {
        return e.low ? fmt::format(" [{:.1f}, {:.1f}]", *e.low * factor, *e.high * factor) : std::string();
    };
    std::vector<std::string> words{fmt::format("C = {:.1f}{} MPa, φ = {:.1f}{}°, R² = {:.3f}", c.value * mega, interval(c, mega),
                                               phi.value * degrees, interval(phi, degrees), envelope.line.r_squared)};
    if (tests.capped > 0) words.push_back(fmt::format("{} of the tests ended by the strain cap, not by a peak", tests.capped));
    return {ChartText{title, words}, Axis{"normal stress, MPa (compression positive)", -left, 1.03 * right},
            Axis{"shear stress, MPa", 0, 1.3 * radius}, std::nullopt, true};
}

void draw_circles(Chart& chart, const EnvelopeTests& tests) {
    std::map<double, std::size_t> colours;
    for (const auto& test : tests.compression) colours.emplace(test.confining, 0);
    std::size_t next = 0;
    for (auto& [pressure, colour] : colours) {
        colour = next++;
        chart.legend(Stroke{palette::series(colour), 4}, fmt::format("σ3 = {:.4g} MPa", pressure * mega));
    }
    for (const auto& test : tests.compression) {
        const Points points = circle(test.confining, test.strength);
        chart.line(points.x, points.y, Stroke{palette::series(colours.at(test.confining)), 2.5});
    }
    const auto tensile = [&](const std::vector<double>& strengths, double high, Colour colour, const std::string& words) {
        for (const double strength : strengths) {
            const Points points = circle(-strength, high * strength);
            chart.line(points.x, points.y, Stroke{colour, 2.5});
        }
        if (!strengths.empty()) chart.legend(Stroke{colour, 4}, words);
    };
    tensile(tests.brazilian, 3, palette::rim, "Brazilian, centre of the disc");
    tensile(tests.direct_tension, 0, palette::tensile, "direct tension");
}

}  // namespace

Drawing draw_envelope(const EnvelopeTests& tests, const std::string& title) {
    const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
    Chart chart = page(tests, envelope, title);
    draw_circles(chart, tests);
    double right = 0;
    for (const auto& test : tests.compression) right = std::max(right, test.strength * mega);
    const Points line = line_of(envelope, right);
    chart.line(line.x, line.y, Stroke{palette::ink, 4});
    chart.legend(Stroke{palette::ink, 4}, "Mohr–Coulomb");
    if (envelope.hoek_brown) {
        const Points hull = hull_of(*envelope.hoek_brown, std::max(largest_confining(tests), 0.1 * right / mega));
        chart.line(hull.x, hull.y, Stroke{palette::ink, 3, true});
        chart.legend(Stroke{palette::ink, 3, true},
                     fmt::format("Hoek–Brown, σci {:.1f} MPa, mi {:.1f}", envelope.hoek_brown->sigma_ci.value * mega,
                                 envelope.hoek_brown->mi.value));
    }
    return chart.finish();
}

}  // namespace graincrack
