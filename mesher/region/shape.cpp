#include "mesher/region/shape.hpp"

#include <cmath>
#include <numbers>

namespace graincrack::mesher {

Region region_of(const Shape& shape) {
    return shape.kind == ShapeKind::disc ? disc(shape.width, shape.pole, shape.diameters) : rectangle(shape.width, shape.height);
}

double turn_to_load(const Shape& shape) { return -std::numbers::pi * shape.loaded_diameter / shape.diameters; }

void turn_to_load(const Shape& shape, std::vector<Point>& points) {
    if (shape.loaded_diameter == 0) return;
    const double angle = turn_to_load(shape);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double radius = shape.width / 2;
    for (Point& p : points) {
        p = {c * p.x - s * p.y, s * p.x + c * p.y};
        if (std::abs(std::abs(p.y) - radius) < 1e-12 * radius) p.y = std::copysign(radius, p.y);
    }
}

}  // namespace graincrack::mesher
