// How long a time step a triangle allows.
#pragma once

#include <algorithm>
#include <cmath>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// Area of the triangle pqr over the root of the sum of its squared sides, m; negative if clockwise. The stable time step of a
/// constant-strain triangle that is free is about in proportion: its highest frequency follows from the trace of its stiffness.
/// A quarter of the side of an equilateral triangle; half an altitude and less of flat ones.
inline double step_length(Point p, Point q, Point r) {
    return signed_area(p, q, r) / std::sqrt(squared_length(q - p) + squared_length(r - q) + squared_length(p - r));
}

/// Of an equilateral triangle, over its side.
inline constexpr double step_length_over_side = 0.25;

/// Cost of a triangle whose step length is a share of a good one: 1 of a good one, and soon the larger the smaller the share. A
/// sum of costs is mostly that of the worst triangles. It rises further for triangles that are inside out.
inline double step_cost(double share) {
    constexpr double least = 0.05;
    const double inverse = 1 / std::max(share, least);
    const double cube = inverse * inverse * inverse;
    return cube * cube * (share < least ? 2 - share / least : 1);
}

}  // namespace graincrack::mesher
