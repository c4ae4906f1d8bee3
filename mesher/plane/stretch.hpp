// The map between a specimen of elongated grains and the plane in which they are equiaxed.
#pragma once

#include <cmath>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// Grains elongated by a ratio along a direction, without a change of area. Without elongation both maps are exact identities.
struct Stretch {
    double ratio = 1;  ///< long over short axis
    double angle = 0;  ///< of the long axis, counter-clockwise from x, rad

    /// A point or vector of the specimen in the plane where grains are equiaxed.
    [[nodiscard]] Point equiaxed(Point p) const { return scaled(p, 1 / std::sqrt(ratio)); }
    /// The inverse.
    [[nodiscard]] Point elongated(Point p) const { return scaled(p, std::sqrt(ratio)); }

private:
    [[nodiscard]] Point scaled(Point p, double along) const {
        const Point axis{std::cos(angle), std::sin(angle)};
        return p + ((along - 1) * dot(p, axis)) * axis + ((1 / along - 1) * cross(axis, p)) * left_of(axis);
    }
};

}  // namespace graincrack::mesher
