// Random numbers that are the same with every compiler and standard library.
#pragma once

#include <cstdint>
#include <random>

namespace graincrack::mesher {

/// Spreads seed and stream over 64 bits, so that neighbouring seeds start far apart (finaliser of splitmix64).
constexpr std::uint64_t mixed_bits(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (stream + 1);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
}

/// A number inside (0, 1) from 64 bits.
constexpr double uniform_of(std::uint64_t bits) { return (static_cast<double>(bits >> 12U) + 0.5) * 0x1.0p-52; }

/// Streams of a seed; those of the attempts at a mesh are numbered from 0.
inline constexpr std::uint64_t open_stream = 999'999;  ///< before the others, since joint sets count upwards
inline constexpr std::uint64_t phase_stream = 1'000'000;
inline constexpr std::uint64_t strength_stream = 1'000'001;
inline constexpr std::uint64_t joint_stream = 1'000'002;  ///< of the first joint set; those of the others follow

/// Stream of random numbers of one seed. The engine is fixed by the C++ standard; the conversions are defined here, because
/// the distributions of the standard library differ between implementations.
class RandomNumbers {
public:
    /// \param stream number of an independent stream of the same seed, such as one for each attempt
    explicit RandomNumbers(std::uint64_t seed, std::uint64_t stream = 0) : engine_(mixed_bits(seed, stream)) {}

    /// Uniform in [0, 1), 53 bits.
    double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
    /// Uniform in [−1, 1).
    double symmetric() { return 2 * uniform() - 1; }
    /// Uniform in 0 … n − 1, n > 0.
    std::uint64_t below(std::uint64_t n) { return static_cast<std::uint64_t>(uniform() * static_cast<double>(n)); }

private:
    std::mt19937_64 engine_;
};

}  // namespace graincrack::mesher
