// Points of the plane and their arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace graincrack::mesher {

/// A non-negative number of a point, a cell and so on, as an index.
constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

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
/// Unit vector of a nonzero vector.
inline Point unit(Point p) { return {p.x / length(p), p.y / length(p)}; }
/// A vector rotated left by a right angle.
constexpr Point left_of(Point p) { return {-p.y, p.x}; }
constexpr Point midpoint(Point p, Point q) { return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}; }
/// Area of the triangle pqr, positive if counter-clockwise, m².
constexpr double signed_area(Point p, Point q, Point r) { return 0.5 * cross(q - p, r - p); }
/// Area of a polygon, negative if its corners are clockwise, m².
constexpr double area_of(std::span<const Point> loop) {
    double sum = 0;
    for (std::size_t i = 2; i < loop.size(); ++i) sum += signed_area(loop[0], loop[i - 1], loop[i]);
    return sum;
}

/// The extent of points; without points low exceeds high.
struct Box {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    [[nodiscard]] double width() const { return high.x - low.x; }
    [[nodiscard]] double height() const { return high.y - low.y; }
    void add(Point p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
};
inline Box box_of(std::span<const Point> points) {
    Box box;
    for (const Point p : points) box.add(p);
    return box;
}

}  // namespace graincrack::mesher
