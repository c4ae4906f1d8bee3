// Normal numbers that are the same everywhere: the standard does not fix those of std::normal_distribution.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace graincrack::test {

/// Mean 0, deviation 1, by Box & Muller.
class Normal {
public:
    explicit Normal(std::uint32_t seed) : engine_(seed) {}
    double operator()() {
        const double u = uniform();
        return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * uniform());
    }
    /// In (0, 1].
    double uniform() { return (static_cast<double>(engine_()) + 1) / 4294967296.0; }

private:
    std::mt19937 engine_;
};

}  // namespace graincrack::test
