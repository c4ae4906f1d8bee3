#include "mesher/assemblage/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/seeds/orientation.hpp"

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

/// Angle between the directions from one point to two others, rad.
double angle(Point at, Point to, Point other) {
    return std::atan2(std::abs(cross(to - at, other - at)), dot(to - at, other - at));
}

}  // namespace

MeshStatistics statistics_of(const Region& region, const PlaneCells& cells) {
    const auto at = [&](int p) { return cells.points[static_cast<std::size_t>(p)]; };
    Distribution edges;
    for (const Edge& e : cells.edges) edges.add(length(at(e[1]) - at(e[0])));
    Distribution diameters;
    double total_area = 0;
    double min_angle = std::numbers::pi;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto loop = cells.loop(cell);
        const auto corner = [&](std::size_t i) { return at(loop[i % loop.size()]); };
        double cell_area = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (i > 1) cell_area += signed_area(corner(0), corner(i - 1), corner(i));
            min_angle = std::min(min_angle, angle(corner(i), corner(i + 1), corner(i + loop.size() - 1)));
        }
        total_area += cell_area;
        diameters.add(std::sqrt(4 * cell_area / std::numbers::pi));
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
    statistics.psi6 = psi6(cells.points, cells.edges);
    statistics.area_error = total_area / area(region) - 1;
    return statistics;
}

}  // namespace graincrack::mesher
