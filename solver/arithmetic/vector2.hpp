// A vector in the plane, the only geometric type of the kernels.
#pragma once

#include <cmath>

namespace graincrack {

struct Vector2 {
    double x = 0;
    double y = 0;
    Vector2& operator+=(const Vector2& b) {
        x += b.x;
        y += b.y;
        return *this;
    }
    Vector2& operator-=(const Vector2& b) {
        x -= b.x;
        y -= b.y;
        return *this;
    }
};
inline Vector2 operator+(Vector2 a, const Vector2& b) { return a += b; }
inline Vector2 operator-(Vector2 a, const Vector2& b) { return a -= b; }
inline Vector2 operator*(double s, const Vector2& a) { return {s * a.x, s * a.y}; }
inline double dot(const Vector2& a, const Vector2& b) { return a.x * b.x + a.y * b.y; }
inline double length(const Vector2& a) { return std::sqrt(dot(a, a)); }

}  // namespace graincrack
