// Random numbers that do not depend on compiler and standard library.
#pragma once

#include <cstdint>
#include <random>

#include "share/base/random_bits.hpp"

namespace graincrack::mesher {

/// Streams of a seed. Those of the attempts at a mesh are numbered from 0; 999'998 is that of the axes of crystals
/// (share/file/fabric.hpp).
inline constexpr std::uint64_t open_stream = 999'999;  ///< before the others, as numbers of joint sets increase
inline constexpr std::uint64_t phase_stream = 1'000'000;
inline constexpr std::uint64_t strength_stream = 1'000'001;
inline constexpr std::uint64_t joint_stream = 1'000'002;  ///< first joint set; the others follow

/// A stream of random numbers of one seed. The C++ standard fixes the engine; the conversions are defined here because
/// distributions differ between standard libraries.
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
