// Addition of structures of numbers, member by member.
#pragma once

#include <array>
#include <bit>
#include <cstddef>

namespace graincrack {

/// A structure with members of type double only, which declares the name `IsSum`.
template <class Sums>
concept SumOfMembers = requires {
    typename Sums::IsSum;
};

template <SumOfMembers Sums>
Sums& operator+=(Sums& sums, const Sums& other) {
    constexpr std::size_t n = sizeof(Sums) / sizeof(double);
    auto total = std::bit_cast<std::array<double, n>>(sums);
    const auto added = std::bit_cast<std::array<double, n>>(other);
    for (std::size_t i = 0; i < n; ++i) total[i] += added[i];
    return sums = std::bit_cast<Sums>(total);
}

}  // namespace graincrack
