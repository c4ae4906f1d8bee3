// Maps between a specimen of elongated grains and the plane in which they are equiaxed.
#pragma once

#include <cmath>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// Elongation of grains at constant area.
struct Elongation {
    double ratio = 1;  ///< long over short axis
    double angle = 0;  ///< direction of the long axis, counter-clockwise from x, rad
};

/// The map that elongates, and its inverse. Without elongation both are exact identities.
class Stretch {
public:
    Stretch() = default;
    explicit Stretch(Elongation elongation)
        : ratio_(elongation.ratio),
          equiaxed_(1 / std::sqrt(elongation.ratio), elongation.angle),
          elongated_(std::sqrt(elongation.ratio), elongation.angle) {}

    [[nodiscard]] double ratio() const { return ratio_; }
    [[nodiscard]] bool is_identity() const { return ratio_ == 1; }
    /// Maps a point or vector of the specimen to the plane where grains are equiaxed.
    [[nodiscard]] Point equiaxed(Point p) const { return equiaxed_.of(p); }
    /// Maps it back.
    [[nodiscard]] Point elongated(Point p) const { return elongated_.of(p); }

private:
    /// A symmetric matrix with the principal values k along a direction and 1/k across it.
    struct Matrix {
        double xx = 1, xy = 0, yy = 1;

        Matrix() = default;
        Matrix(double k, double angle) {
            const Point axis{std::cos(angle), std::sin(angle)};
            const double along = k - 1;
            const double across = 1 / k - 1;
            xx += along * axis.x * axis.x + across * axis.y * axis.y;
            xy += (along - across) * axis.x * axis.y;
            yy += along * axis.y * axis.y + across * axis.x * axis.x;
        }
        [[nodiscard]] Point of(Point p) const { return {xx * p.x + xy * p.y, xy * p.x + yy * p.y}; }
    };

    double ratio_ = 1;
    Matrix equiaxed_;
    Matrix elongated_;
};

}  // namespace graincrack::mesher
