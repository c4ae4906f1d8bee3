#include "post/fit/mohr_coulomb.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "share/base/error.hpp"

namespace graincrack {

double mohr_coulomb_slope(double friction_angle) {
    const double sine = std::sin(friction_angle);
    return (1 + sine) / (1 - sine);
}

std::optional<double> laboratory_slope(const Material& material) {
    const auto entry = [&material](const char* key) {
        const auto found = material.laboratory.find(key);
        return found == material.laboratory.end() ? std::nullopt : std::optional(found->second);
    };
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
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (!std::isfinite(confining[i]) || !std::isfinite(strength[i])) {
            throw InputError(fmt::format("envelope: test {} of {} has no finite strength and confining pressure", i + 1, n));
        }
        mean_x += confining[i] / static_cast<double>(n);
        mean_y += strength[i] / static_cast<double>(n);
    }
    double sxx = 0;
    double sxy = 0;
    double syy = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = confining[i] - mean_x;
        const double dy = strength[i] - mean_y;
        sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
    const double round_off = 1e-12 * mean_x;
    if (n < 2 || sxx <= static_cast<double>(n) * round_off * round_off) {
        throw InputError(
            fmt::format("envelope: {} {} at one confining pressure; cohesion and friction angle need two or more pressures", n,
                        n == 1 ? "strength" : "strengths"));
    }
    MohrCoulomb fit;
    fit.slope = sxy / sxx;
    fit.intercept = mean_y - fit.slope * mean_x;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    fit.cohesion = fit.slope > 0 ? fit.intercept / (2 * std::sqrt(fit.slope)) : nan;
    fit.friction_angle = fit.slope > 0 ? std::asin((fit.slope - 1) / (fit.slope + 1)) : nan;
    fit.r_squared = syy > 0 ? sxy * sxy / (sxx * syy) : 1;
    return fit;
}

}  // namespace graincrack
