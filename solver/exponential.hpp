// e^(−x) for x ≥ 0: the only transcendental function of the contact law, the same on every machine.
#pragma once

#include <bit>
#include <cstdint>

namespace graincrack {

/// e^(−x) for 0 ≤ x, relative error below 3e-16; 0 beyond x = 700.
///
/// e^(−x) = 2^(−k) e^r with k = round(x / ln 2) and |r| ≤ ln 2 / 2; e^r by its Taylor polynomial of degree 13, whose
/// remainder (ln 2 / 2)^14 / 14! is 4e-18. No table, no branch: a compiler can vectorise it.
inline double exp_of_minus(double x) {
    constexpr double inv_ln2 = 1.44269504088896340736;
    constexpr double ln2_high = 6.93147180369123816490e-01;
    constexpr double ln2_low = 1.90821492927058770002e-10;
    constexpr double round_shift = 6755399441055744.0;  // 1.5 · 2^52: adding it rounds to an integer
    const double limited = x < 700.0 ? x : 700.0;
    const double shifted = limited * inv_ln2 + round_shift;
    const double k = shifted - round_shift;
    const double r = (k * ln2_high - limited) + k * ln2_low;
    double p = 1.0 / 6227020800.0;
    p = p * r + 1.0 / 479001600.0;
    p = p * r + 1.0 / 39916800.0;
    p = p * r + 1.0 / 3628800.0;
    p = p * r + 1.0 / 362880.0;
    p = p * r + 1.0 / 40320.0;
    p = p * r + 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    p = p * r + 1.0;
    p = p * r + 1.0;
    // 2^(−k): the low bits of `shifted` hold k.
    const auto bits = std::bit_cast<std::uint64_t>(shifted);
    const double scale = std::bit_cast<double>((std::uint64_t{1023} - bits) << 52);
    return x < 700.0 ? p * scale : 0.0;
}

}  // namespace graincrack
