#include "post/fit/mohr_coulomb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "share/base/error.hpp"

namespace graincrack {

double mohr_coulomb_slope(double friction_angle) {
    const double sine = std::sin(friction_angle);
    return (1 + sine) / (1 - sine);
}

double friction_angle_of(double slope) { return slope > 0 ? std::asin((slope - 1) / (slope + 1)) : -std::numbers::pi / 2; }

std::optional<double> laboratory_slope(const Material& material) {
    const auto entry = [&material](const char* key) { return material.laboratory_value(key); };
    if (const auto angle = entry("friction_angle")) return mohr_coulomb_slope(*angle);
    const auto ucs = entry("compressive_strength");
    const auto confined = entry("confined_strength");
    const auto pressure = entry("confining_pressure");
    if (ucs && confined && pressure && *pressure > 0) {
        if (*confined > *ucs) return (*confined - *ucs) / *pressure;
        throw InputError(
            fmt::format("{}: laboratory.confined_strength is not above compressive_strength; a rock is stronger under "
                        "pressure",
                        material.file.string()));
    }
    const auto cohesion = entry("cohesion");
    return ucs && cohesion ? std::optional(std::pow(*ucs / (2 * *cohesion), 2)) : std::nullopt;
}

MohrCoulomb fit_mohr_coulomb(std::span<const double> confining, std::span<const double> strength) {
    if (confining.size() != strength.size()) throw std::invalid_argument("a confining pressure is needed for each strength");
    const std::size_t n = confining.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!std::isfinite(confining[i]) || !std::isfinite(strength[i])) {
            throw InputError(fmt::format("envelope: test {} of {} has no finite strength and confining pressure", i + 1, n));
        }
    }
    const auto [least, most] = std::ranges::minmax_element(confining);
    constexpr double round_off = 1e-12;
    const std::optional<Line> line = n < 2 || *most - *least <= round_off * *most ? std::nullopt : fit_line(confining, strength);
    if (!line) {
        throw InputError(
            fmt::format("envelope: {} {} at one confining pressure; cohesion and friction angle need two or more pressures", n,
                        n == 1 ? "strength" : "strengths"));
    }
    MohrCoulomb fit{*line};
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    fit.cohesion = fit.slope > 0 ? fit.intercept / (2 * std::sqrt(fit.slope)) : nan;
    fit.friction_angle = fit.slope > 0 ? friction_angle_of(fit.slope) : nan;
    return fit;
}

}  // namespace graincrack
