// Normal random numbers that are equal on all machines; the standard does not determine those of std::normal_distribution.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace graincrack::test {

/// Normal numbers with mean 0 and standard deviation 1 (Box & Muller 1958).
class Normal {
public:
    explicit Normal(std::uint32_t seed) : engine_(seed) {}
    double operator()() {
        const double u = uniform();
        return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * uniform());
    }
    /// A uniform number in (0, 1].
    double uniform() { return (static_cast<double>(engine_()) + 1) / 4294967296.0; }

private:
    std::mt19937 engine_;
};

}  // namespace graincrack::test
