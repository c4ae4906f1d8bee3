#include "post/fit/hoek_brown.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "post/statistics/nonlinear_fit.hpp"

namespace graincrack {

namespace {

/// Strengths in units of the largest, so that σci and mi are of like size for the solver.
struct Data {
    double scale = 1;
    std::vector<double> confining;
    std::vector<double> strength;
    std::vector<double> tensile;
    [[nodiscard]] std::size_t size() const { return strength.size() + tensile.size(); }
};

std::vector<double> scaled(std::span<const double> values, double factor) {
    std::vector<double> out(values.begin(), values.end());
    for (double& value : out) value *= factor;
    return out;
}

/// (σ1 − σ3)², but at least a small positive value: the slope of the root stays finite when the solver tries parameters far off.
double envelope(double sigma_ci, double mi, double confining) {
    return confining + std::sqrt(std::max(sigma_ci * (sigma_ci + mi * confining), 1e-12));
}

double tension(double sigma_ci, double mi) { return sigma_ci * (std::sqrt(mi * mi + 4) - mi) / 2; }

/// (σ1 − σ3)² = σci² + mi σci σ3 is a straight line in σ3: exact for exact data.
std::vector<double> first_guess(const Data& data) {
    std::vector<double> squares(data.confining.size());
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = std::pow(data.strength[i] - data.confining[i], 2);
    const std::optional<Line> line = fit_line(data.confining, squares);
    const double smallest = *std::min_element(squares.begin(), squares.end());
    const double sigma_ci = std::sqrt(line->intercept > 0.01 * smallest ? line->intercept : 0.1 * smallest);
    return {sigma_ci, line->slope / sigma_ci};
}

Estimate times(Estimate e, double scale) {
    e.value *= scale;
    for (auto* end : {&e.low, &e.high}) {
        if (*end) **end *= scale;
    }
    return e;
}

std::optional<HoekBrown> fit(const Data& data, bool relative) {
    const auto residuals = [&](std::span<const double> x, std::span<double> f) {
        const auto residual = [&](double model, double measured) { return (model - measured) / (relative ? measured : 1); };
        const std::size_t n = data.strength.size();
        for (std::size_t i = 0; i < n; ++i) f[i] = residual(envelope(x[0], x[1], data.confining[i]), data.strength[i]);
        for (std::size_t i = 0; i < data.tensile.size(); ++i) f[n + i] = residual(tension(x[0], x[1]), data.tensile[i]);
    };
    const std::optional<NonlinearFit> found = fit_nonlinear(residuals, first_guess(data), data.size());
    if (!found || !(found->parameters[0] > 1e-5)) return std::nullopt;
    return HoekBrown{times(found->estimate(0), data.scale), found->estimate(1)};
}

std::optional<Data> prepare(std::span<const double> confining, std::span<const double> strength,
                            std::span<const double> tensile) {
    const bool two = std::any_of(confining.begin(), confining.end(), [&](double c) { return c != confining[0]; });
    if (!two) return std::nullopt;
    const double scale = *std::max_element(strength.begin(), strength.end());
    if (!(scale > 0)) return std::nullopt;
    return Data{scale, scaled(confining, 1 / scale), scaled(strength, 1 / scale), scaled(tensile, 1 / scale)};
}

}  // namespace

double HoekBrown::strength(double confining) const {
    const double square = sigma_ci.value * (sigma_ci.value + mi.value * confining);
    return square >= 0 ? confining + std::sqrt(square) : std::numeric_limits<double>::quiet_NaN();
}

double HoekBrown::tensile_strength() const { return tension(sigma_ci.value, mi.value); }

std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength) {
    const std::optional<Data> data = prepare(confining, strength, {});
    return data ? fit(*data, false) : std::nullopt;
}

std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength,
                                        std::span<const double> tensile) {
    const std::optional<Data> data = prepare(confining, strength, tensile);
    return data ? fit(*data, true) : std::nullopt;
}

}  // namespace graincrack
