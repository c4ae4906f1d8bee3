// Estimates the time step that a triangle allows.
#pragma once

#include <algorithm>
#include <cmath>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// Area of the triangle pqr over the root of the sum of its squared sides, m; negative if clockwise. The stable time step of a
/// free constant-strain triangle is about proportional to it, because its highest frequency follows from the trace of its
/// stiffness. It is a quarter of the side of an equilateral triangle, and at most half an altitude of a flat one.
inline double step_length(Point p, Point q, Point r) {
    return signed_area(p, q, r) / std::sqrt(squared_length(q - p) + squared_length(r - q) + squared_length(p - r));
}

/// Step length of an equilateral triangle over its side.
inline constexpr double step_length_over_side = 0.25;

/// Cost of a triangle by its step length over that of a good one: 1 for a good triangle, rising with the sixth power of the
/// inverse. A sum of costs is dominated by the worst triangles. It rises further for inverted triangles.
inline double step_cost(double share) {
    constexpr double least = 0.05;
    const double inverse = 1 / std::max(share, least);
    const double cube = inverse * inverse * inverse;
    return cube * cube * (share < least ? 2 - share / least : 1);
}

}  // namespace graincrack::mesher
