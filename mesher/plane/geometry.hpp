// Points of the plane and their arithmetic.
#pragma once

#include <cmath>

namespace graincrack::mesher {

/// A point or vector, m.
struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

constexpr Point operator+(Point p, Point q) { return {p.x + q.x, p.y + q.y}; }
constexpr Point operator-(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
constexpr Point operator*(double s, Point p) { return {s * p.x, s * p.y}; }
constexpr double dot(Point p, Point q) { return p.x * q.x + p.y * q.y; }
constexpr double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }
constexpr double squared_length(Point p) { return dot(p, p); }
inline double length(Point p) { return std::sqrt(squared_length(p)); }
/// The direction of a vector that is not zero.
inline Point unit(Point p) { return {p.x / length(p), p.y / length(p)}; }
/// A vector turned to its left by a right angle.
constexpr Point left_of(Point p) { return {-p.y, p.x}; }
constexpr Point midpoint(Point p, Point q) { return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}; }
/// Area of the triangle pqr, positive if counter-clockwise, m².
constexpr double signed_area(Point p, Point q, Point r) { return 0.5 * cross(q - p, r - p); }

}  // namespace graincrack::mesher
