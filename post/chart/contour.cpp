#include "post/chart/contour.hpp"

#include <cmath>

namespace graincrack {

namespace {

using Point = std::array<double, 2>;

struct Corner {
    Point place;
    double value;
};

/// The point between two corners at which the level is crossed.
Point crossing(const Corner& a, const Corner& b, double level) {
    const double share = (level - a.value) / (b.value - a.value);
    return {a.place[0] + share * (b.place[0] - a.place[0]), a.place[1] + share * (b.place[1] - a.place[1])};
}

/// A triangle is crossed by one segment or none: no ambiguous saddle.
void add_triangle(const std::array<Corner, 3>& corners, double level, std::vector<std::array<Point, 2>>& segments) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner& a = corners[k];
        const Corner& b = corners[(k + 1) % 3];
        if (std::isnan(a.value) || std::isnan(b.value)) return;
        if ((a.value < level) != (b.value < level)) points.push_back(crossing(a, b, level));
    }
    if (points.size() == 2) segments.push_back({points[0], points[1]});
}

}  // namespace

std::vector<std::array<Point, 2>> contour_segments(const GridValues& grid, double level) {
    std::vector<std::array<Point, 2>> segments;
    const std::size_t nx = grid.x.size();
    const auto corner = [&](std::size_t i, std::size_t j) { return Corner{{grid.x[i], grid.y[j]}, grid.value[j * nx + i]}; };
    for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) {
        for (std::size_t i = 0; i + 1 < nx; ++i) {
            add_triangle({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)}, level, segments);
            add_triangle({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)}, level, segments);
        }
    }
    return segments;
}

}  // namespace graincrack
