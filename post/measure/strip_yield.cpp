#include "post/measure/strip_yield.hpp"

#include <cmath>
#include <numbers>

namespace graincrack {

namespace {

/// Root of the mean of K_I² over cracks from a to a + ρ, over K_I of a.
double mean_intensity(const CrackedSpecimen& specimen, double zone) {
    constexpr int n = 64;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += std::pow(specimen.intensity(specimen.crack + (i + 0.5) / n * zone), 2);
    return std::sqrt(sum / n) / specimen.intensity(specimen.crack);
}

}  // namespace

double strip_yield_zone(double shown, double tensile_strength) {
    return std::numbers::pi / 8 * std::pow(shown / tensile_strength, 2);
}

std::optional<double> toughness_at_infinite_size(double shown, double tensile_strength, const CrackedSpecimen& specimen) {
    const double zone = strip_yield_zone(shown, tensile_strength);
    if (!(specimen.crack + zone <= specimen.deepest)) return std::nullopt;
    return shown * mean_intensity(specimen, zone);
}

std::optional<double> toughness_at_size(double infinite, double tensile_strength, const CrackedSpecimen& specimen) {
    double low = 0;
    double high = infinite;  // a longer crack has no smaller K_I
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        const auto of_middle = toughness_at_infinite_size(middle, tensile_strength, specimen);
        (of_middle && *of_middle < infinite ? low : high) = middle;
    }
    const auto found = toughness_at_infinite_size(low, tensile_strength, specimen);
    constexpr double tolerance = 1e-6;
    return found && std::abs(*found / infinite - 1) < tolerance ? std::optional(low) : std::nullopt;
}

}  // namespace graincrack
