#include "mesher/cells/polygon.hpp"

#include <cmath>
#include <cstddef>

namespace graincrack::mesher {

namespace {

/// Least area of the triangles between centroid and sides, over that of the polygon and its number of sides. Chosen by trial.
constexpr double least_share = 1e-3;

}  // namespace

PolygonMoments moments(const std::vector<Point>& corners) {
    PolygonMoments result;
    const Point origin = corners.front();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const double area = signed_area(origin, corners[i], corners[i + 1]);
        result.area += area;
        result.centroid = result.centroid + (area / 3) * ((corners[i] - origin) + (corners[i + 1] - origin));
    }
    result.centroid = origin + (1 / result.area) * result.centroid;
    return result;
}

bool is_sound(std::span<const Point> loop) {
    const double area = area_of(loop);
    if (!(area > 0)) return false;
    Point centroid;
    for (std::size_t i = 2; i < loop.size(); ++i) {
        const double part = signed_area(loop[0], loop[i - 1], loop[i]);
        centroid = centroid + (part / (3 * area)) * (loop[0] + loop[i - 1] + loop[i]);
    }
    const double least = least_share * area / static_cast<double>(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (!(signed_area(centroid, loop[i], loop[(i + 1) % loop.size()]) > least)) return false;
    }
    return true;
}

std::vector<Point> corners_of(const PlaneCells& cells, std::size_t cell) {
    std::vector<Point> corners;
    for (const int p : cells.loop(cell)) corners.push_back(cells.points[index(p)]);
    return corners;
}

std::vector<double> areas_of(const PlaneCells& cells) {
    std::vector<double> areas;
    areas.reserve(cells.size());
    for (std::size_t cell = 0; cell < cells.size(); ++cell) areas.push_back(area_of(corners_of(cells, cell)));
    return areas;
}

std::vector<Point> tangents_of(const PlaneCells& cells) {
    std::vector<Point> tangents(cells.points.size());
    for (const Side& side : cells.sides) {
        const auto from = index(side.from);
        const auto to = index(side.to);
        tangents[from] = tangents[to] = unit(cells.points[to] - cells.points[from]);
    }
    return tangents;
}

Elongation elongation_of(const PlaneCells& cells) {
    double xx = 0, xy = 0, yy = 0;
    for (const Edge& e : cells.edges) {
        const Point d = cells.points[index(e[1])] - cells.points[index(e[0])];
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    const double mean = (xx + yy) / 2;
    const double half_difference = std::hypot((xx - yy) / 2, xy);
    return {std::sqrt((mean + half_difference) / (mean - half_difference)), 0.5 * std::atan2(2 * xy, xx - yy)};
}

}  // namespace graincrack::mesher
