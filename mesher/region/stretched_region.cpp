#include "mesher/region/stretched_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace graincrack::mesher {

namespace {

/// Adds points of an arc from `from` over an angle, without its end.
void add_arc(std::vector<Point>& points, Point centre, Point from, double angle, double side) {
    constexpr int fewest = 8;
    const Point start = from - centre;
    const int n = std::max(fewest, static_cast<int>(std::abs(angle) * length(start) / side));
    for (int i = 0; i < n; ++i) {
        const double turn = angle * i / n;
        points.push_back(centre + std::cos(turn) * start + std::sin(turn) * left_of(start));
    }
}

}  // namespace

Region stretched(const Region& region, const Stretch& stretch, double side) {
    Region image = region;
    if (stretch.is_identity()) return image;
    for (Loop& loop : image.loops) {
        std::vector<Point> corners;
        if (loop.circle) {
            const bool outer = &loop == &image.loops.front();
            const Circle& circle = *loop.circle;
            add_arc(corners, circle.centre, circle.centre + Point{circle.radius, 0}, (outer ? 2 : -2) * std::numbers::pi, side);
        }
        for (std::size_t i = 0; i < loop.corners.size(); ++i) {
            const Point from = loop.corners[i];
            const auto centre = loop.centre(i);
            if (!centre) {
                corners.push_back(from);
                continue;
            }
            const Curve arc{Curve::Kind::arc, from, loop.corners[(i + 1) % loop.corners.size()], {}, Circle{*centre, 0}};
            add_arc(corners, *centre, from, arc.arc_angle(), side);
        }
        for (Point& p : corners) p = stretch.equiaxed(p);
        const std::size_t n = corners.size();
        loop = {std::move(corners), std::vector<std::uint8_t>(n, loop.parts.front())};
    }
    for (PrescribedEdge& e : image.edges) {
        e.from = stretch.equiaxed(e.from);
        e.to = stretch.equiaxed(e.to);
    }
    return image;
}

}  // namespace graincrack::mesher
