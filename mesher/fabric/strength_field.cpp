#include "mesher/fabric/strength_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesher/fabric/crystals.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr int n_modes = 512;

/// ln(1 − Φ(z)) of the standard normal distribution, accurate also if 1 − Φ is small.
double log_survival(double z) {
    const double tail = 0.5 * std::erfc(std::abs(z) / std::numbers::sqrt2);
    return z > 0 ? std::log(tail) : std::log1p(-tail);
}

}  // namespace

void check(const StrengthRequest& request) {
    if (request.modulus || !(request.correlation || request.seed)) return;
    throw UsageError(std::string(request.correlation ? "--strength-correlation" : "--strength-seed") +
                     ": strength does not scatter; add --strength-modulus 5");
}

double weibull_factor(double log_q, double modulus) { return std::pow(-log_q, 1 / modulus) / std::tgamma(1 + 1 / modulus); }

// The spectral density of exp(−d/L) in the plane has wave vectors in all directions, whose lengths k have the distribution 1 − (1
// + k² L²)^(−1/2). One length is drawn from each of `n_modes` equal parts of it, and directions are golden sections apart, so
// that a single field has the autocorrelation of the mean over all fields.
GaussianField::GaussianField(double length, std::uint64_t seed) {
    RandomNumbers random(seed, strength_stream);
    const double first = random.uniform();
    for (int i = 0; i < n_modes; ++i) {
        const double beyond = 1 - (i + random.uniform()) / n_modes;
        const double k = std::sqrt(1 / (beyond * beyond) - 1) / length;
        const double direction = std::numbers::pi * (first + i / std::numbers::phi);
        modes_.push_back({k * Point{std::cos(direction), std::sin(direction)}, 2 * std::numbers::pi * random.uniform()});
    }
}

double GaussianField::operator()(Point at) const {
    double sum = 0;
    for (const Mode& mode : modes_) sum += std::cos(dot(mode.wave_vector, at) + mode.phase);
    return std::sqrt(2.0 / n_modes) * sum;
}

void assign_strength_factors(Specimen& specimen, std::span<const int> crystal_of_grain, double turn,
                             const StrengthRequest& request) {
    if (!request.modulus) return;
    const std::uint64_t seed = request.seed.value_or(specimen.seed);
    std::optional<GaussianField> field;
    if (request.correlation) field.emplace(*request.correlation, seed);
    const auto crystals = crystals_of_contacts(specimen, crystal_of_grain);
    const Point x_axis{std::cos(turn), std::sin(turn)};
    const auto log_q = [&](std::size_t first, std::size_t last) {
        if (field) {
            const auto& [x1, y1] = specimen.node_position[index(specimen.contact_nodes[first][0])];
            const auto& [x2, y2] = specimen.node_position[index(specimen.contact_nodes[last][1])];
            const Point middle = midpoint({x1, y1}, {x2, y2});
            return log_survival((*field)({dot(middle, x_axis), dot(middle, left_of(x_axis))}));
        }
        const auto& [low, high] = crystals[first];
        const std::uint64_t bits = mixed_bits(mixed_bits(seed, strength_stream), static_cast<std::uint64_t>(low));
        return std::log(uniform_of(mixed_bits(bits, static_cast<std::uint64_t>(high))));
    };
    const auto& boundary = specimen.contact_grain_boundary;
    specimen.contact_strength_factor.clear();
    for (std::size_t c = 0; c < specimen.n_contacts();) {
        std::size_t end = c + 1;
        while (end < specimen.n_contacts() && boundary[end] == boundary[c]) ++end;
        const bool is_flaw = !specimen.contact_flaw.empty() && specimen.contact_flaw[c] > 0;  // flaws have their own strength
        const double factor = is_flaw ? 1 : weibull_factor(log_q(c, end - 1), *request.modulus);
        specimen.contact_strength_factor.resize(end, factor);
        c = end;
    }
}

}  // namespace graincrack::mesher
