#include "mesher/cells/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/seeds/orientation.hpp"

namespace graincrack::mesher {

namespace {

/// Mean, variation and extremes of a stream of lengths.
struct Distribution {
    double n = 0, mean = 0;
    double squares = 0;  ///< sum of squared deviations
    double min = std::numeric_limits<double>::infinity();
    double max = 0;

    void add(double value) {  // Welford's algorithm, which loses no digits in long sums
        n += 1;
        const double deviation = value - mean;
        mean += deviation / n;
        squares += deviation * (value - mean);
        min = std::min(min, value);
        max = std::max(max, value);
    }
    [[nodiscard]] double variation() const { return n > 0 ? std::sqrt(squares / n) / mean : 0; }
};

double equal_area_diameter(double area) { return std::sqrt(4 * area / std::numbers::pi); }

/// Angle between the directions from one point to two others, rad.
double angle(Point at, Point to, Point other) {
    return std::atan2(std::abs(cross(to - at, other - at)), dot(to - at, other - at));
}

MeshStatistics statistics_of(const Distribution& edges, const Distribution& diameters) {
    MeshStatistics statistics;
    statistics.mean_edge = edges.mean;
    statistics.edge_variation = edges.variation();
    statistics.min_edge = edges.min;
    statistics.max_edge = edges.max;
    statistics.mean_diameter = diameters.mean;
    statistics.diameter_variation = diameters.variation();
    statistics.min_diameter = diameters.min;
    statistics.max_diameter = diameters.max;
    return statistics;
}

}  // namespace

MeshStatistics statistics_of(const Region& region, const PlaneCells& cells) {
    const auto at = [&](int p) { return cells.points[index(p)]; };
    Distribution edges;
    for (const Edge& e : cells.edges) edges.add(length(at(e[1]) - at(e[0])));
    Distribution diameters;
    double total_area = 0, min_angle = std::numbers::pi;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto loop = cells.loop(cell);
        const auto corner = [&](std::size_t i) { return at(loop[i % loop.size()]); };
        double cell_area = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (i > 1) cell_area += signed_area(corner(0), corner(i - 1), corner(i));
            min_angle = std::min(min_angle, angle(corner(i), corner(i + 1), corner(i + loop.size() - 1)));
        }
        total_area += cell_area;
        diameters.add(equal_area_diameter(cell_area));
    }
    MeshStatistics statistics = statistics_of(edges, diameters);
    statistics.min_angle = min_angle;
    statistics.psi6 = psi6(cells.points, cells.edges);
    statistics.area_error = total_area / area(region) - 1;
    return statistics;
}

MeshStatistics statistics_of(const Specimen& specimen) {
    std::vector<Point> points;
    for (const auto& p : specimen.node_position) points.push_back({p[0], p[1]});
    const auto at = [&](std::int32_t node) { return points[index(node)]; };
    std::vector<Edge> sides;  // of grains
    for (const auto& nodes : specimen.contact_nodes) sides.push_back({nodes[0], nodes[1]});
    for (const auto& nodes : specimen.boundary_edges) sides.push_back({nodes[0], nodes[1]});
    const bool are_triangles = specimen.n_elements() == specimen.n_grains();
    Distribution edges;
    Distribution diameters;
    for (const double area : specimen.grain_area) {
        diameters.add(equal_area_diameter(area));
        if (!are_triangles) edges.add(std::sqrt(4 * area / std::numbers::sqrt3));
    }
    for (const Edge& side : sides) {
        if (are_triangles) edges.add(length(at(side[1]) - at(side[0])));
    }
    MeshStatistics statistics = statistics_of(edges, diameters);
    statistics.min_angle = std::numbers::pi;
    for (const auto& e : specimen.element_nodes) {
        for (std::size_t k = 0; k < 3; ++k) {
            statistics.min_angle = std::min(statistics.min_angle, angle(at(e[k]), at(e[(k + 1) % 3]), at(e[(k + 2) % 3])));
        }
    }
    statistics.psi6 = psi6(points, sides);
    return statistics;
}

void measure_edges(const Region& region, const PlaneCells& cells, const SizeField& size, MeshReport& report) {
    report.spread = spread_of_edges(cells.points, cells.edges, size);
    if (!is_plain(region) || !size.is_uniform()) report.min_angle = statistics_of(region, cells).min_angle;
}

void measure_diameters(const MeshPlan& plan, const PlaneCells& cells, MeshReport& report) {
    std::vector<double> areas = areas_of(cells);
    const auto n = static_cast<double>(areas.size());
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
        report.mean_diameter += equal_area_diameter(areas[cell]) / n;
        if (!plan.size.varies()) continue;
        const double size = plan.size.graded(moments(corners_of(cells, cell)).centroid);
        areas[cell] /= size * size;
    }
    report.spread = diameter_variation(areas);
}

}  // namespace graincrack::mesher
