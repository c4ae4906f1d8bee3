// e^(−x) for x ≥ 0: the only transcendental function of the contact law, the same on every machine.
#pragma once

#include <bit>
#include <cstdint>

#include "solver/arithmetic/simd.hpp"

namespace graincrack {

/// e^(−x) for 0 ≤ x, relative error below 3e-16; 0 beyond x = 700.
///
/// e^(−x) = 2^(−k) e^r with k = round(x / ln 2) and |r| ≤ ln 2 / 2; e^r = 1 + r + r² q(r) with q the polynomial of degree 9 that
/// meets (e^r − 1 − r)/r² in the ten Chebyshev points of that interval: 1.6e-17 of e^r. No table, no branch: a compiler can
/// vectorise it.
GRAINCRACK_INLINE double exp_of_minus(double x) {
    constexpr double inv_ln2 = 1.44269504088896340736;
    constexpr double ln2_high = 6.93147180369123816490e-01;
    constexpr double ln2_low = 1.90821492927058770002e-10;
    constexpr double round_shift = 6755399441055744.0;  // 1.5 · 2^52: adding it rounds to an integer
    const double limited = x < 700.0 ? x : 700.0;
    const double shifted = limited * inv_ln2 + round_shift;
    const double k = shifted - round_shift;
    const double r = (k * ln2_high - limited) + k * ln2_low;
    // Pairs, pairs of pairs and so on: short chains that a processor works on side by side.
    const double r2 = r * r;
    const double r4 = r2 * r2;
    const double q01 = 0.5000000000000001 + 0.16666666666666669 * r;
    const double q23 = 0.041666666666624164 + 0.008333333333330065 * r;
    const double q45 = 0.001388888891719689 + 0.00019841269863040675 * r;
    const double q67 = 2.480152132210459e-05 + 2.7557268480106926e-06 * r;
    const double q89 = 2.762007600563138e-07 + 2.5100375929185925e-08 * r;
    const double q = (q01 + q23 * r2) + ((q45 + q67 * r2) + q89 * r4) * r4;
    const double p = 1.0 + (r + r2 * q);
    // 2^(−k): the low bits of `shifted` hold k.
    const auto bits = std::bit_cast<std::uint64_t>(shifted);
    const double scale = std::bit_cast<double>((std::uint64_t{1023} - bits) << 52);
    return x < 700.0 ? p * scale : 0.0;
}

}  // namespace graincrack
