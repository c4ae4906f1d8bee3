// Quadrature of smooth functions, more accurate than the tolerance of any test of an area.
#pragma once

#include <array>
#include <cstddef>

namespace graincrack::test {

/// ∫ f over [a, b] by Gauss's rule with five points on `panels` panels, in ascending order: exact for polynomials of degree 9 on
/// a panel.
template <class Function>
double integral(Function&& f, double a, double b, int panels) {
    constexpr std::array<double, 5> at{-0.906179845938664, -0.538469310105683, 0, 0.538469310105683, 0.906179845938664};
    constexpr std::array<double, 5> weight{0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                           0.236926885056189};
    double sum = 0;
    const double half = 0.5 * (b - a) / panels;
    for (int p = 0; p < panels; ++p) {
        for (std::size_t k = 0; k < 5; ++k) sum += weight[k] * half * f(a + half * (2 * p + 1 + at[k]));
    }
    return sum;
}

}  // namespace graincrack::test
