#include "mesher/mesh_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/edge_orientation.hpp"

namespace graincrack::mesher {

namespace {

/// Mean, variation and extremes of a stream of lengths.
struct Distribution {
    double n = 0;
    double mean = 0;
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

/// Smallest angle of a triangle, rad.
double smallest_angle(Point p, Point q, Point r) {
    const auto angle = [](Point at, Point to, Point other) {
        return std::atan2(std::abs(cross(to - at, other - at)), dot(to - at, other - at));
    };
    return std::min({angle(p, q, r), angle(q, r, p), angle(r, p, q)});
}

}  // namespace

MeshStatistics mesh_statistics(const Shape& shape, const PlaneMesh& mesh) {
    const auto at = [&](int p) { return mesh.points[static_cast<std::size_t>(p)]; };
    Distribution edges;
    for (const Edge& e : mesh.edges) edges.add(length(at(e[1]) - at(e[0])));
    Distribution diameters;
    double area = 0;
    double min_angle = std::numbers::pi;
    for (const Triangle& t : mesh.triangles) {
        const double grain_area = signed_area(at(t[0]), at(t[1]), at(t[2]));
        area += grain_area;
        diameters.add(std::sqrt(4 * grain_area / std::numbers::pi));
        min_angle = std::min(min_angle, smallest_angle(at(t[0]), at(t[1]), at(t[2])));
    }
    MeshStatistics statistics;
    statistics.mean_edge = edges.mean;
    statistics.edge_variation = edges.variation();
    statistics.min_edge = edges.min;
    statistics.max_edge = edges.max;
    statistics.mean_diameter = diameters.mean;
    statistics.diameter_variation = diameters.variation();
    statistics.min_diameter = diameters.min;
    statistics.max_diameter = diameters.max;
    statistics.min_angle = min_angle;
    statistics.psi6 = psi6(mesh.points, mesh.edges);
    statistics.area_error = area / shape.area() - 1;
    return statistics;
}

}  // namespace graincrack::mesher
