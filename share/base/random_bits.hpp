// Pseudo-random bits from a seed and a number. They are the same with every compiler and in any order of calls.
#pragma once

#include <cstdint>

namespace graincrack {

/// Spreads seed and stream over 64 bits, so that neighbouring seeds start far apart (finaliser of splitmix64).
constexpr std::uint64_t mixed_bits(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (stream + 1);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
}

/// A number inside (0, 1) from 64 bits.
constexpr double uniform_of(std::uint64_t bits) { return (static_cast<double>(bits >> 12U) + 0.5) * 0x1.0p-52; }

}  // namespace graincrack
