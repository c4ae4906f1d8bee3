#include "post/measure/bending.hpp"

#include <cmath>
#include <numbers>

namespace graincrack {

double nominal_bending_stress(double load, double span, double height) { return 1.5 * load * span / (height * height); }

double notched_beam_intensity(double load, double notch, double span, double height) {
    const double a = notch / height;
    const double b = 1 - a;
    const double four_heights = 1.9 - a * (-0.089 + 0.603 * b - 0.441 * b * b + 1.223 * b * b * b);
    const double pure_bending = 1.989 - a * b * (0.448 - 0.458 * b + 1.226 * b * b);
    const double p = pure_bending + 4 * height / span * (four_heights - pure_bending);
    const double shape = std::sqrt(a) * p / (std::pow(b, 1.5) * (1 + 2 * a));
    return nominal_bending_stress(load, span, height) * std::sqrt(height) * shape;
}

double half_disc_intensity(double load, double notch, double span, double radius) {
    const double s = span / (2 * radius);
    const double b = notch / radius;
    const double shape = -1.297 + 9.516 * s - (0.47 + 16.457 * s) * b + (1.071 + 34.401 * s) * b * b;
    return load * std::sqrt(std::numbers::pi * notch) / (2 * radius) * shape;
}

}  // namespace graincrack
