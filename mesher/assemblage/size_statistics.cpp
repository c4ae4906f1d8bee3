#include "mesher/assemblage/size_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/assemblage/statistics.hpp"

namespace graincrack::mesher {

SizeStatistics size_statistics_of(const Region& region, const PlaneCells& cells, const SizeField& size, double edge,
                                  const std::optional<Grading>& grading) {
    SizeStatistics result;
    result.spread = spread_of_edges(cells.points, cells.edges, size);
    if (is_plain(region) && size.is_uniform()) return result;
    result.min_angle = statistics_of(region, cells).min_angle;
    if (!grading) return result;
    const GradedSize graded(*grading, region);
    std::array<double, 2> n{};
    for (const Edge& e : cells.edges) {
        const Point p = cells.points[static_cast<std::size_t>(e[0])];
        const Point q = cells.points[static_cast<std::size_t>(e[1])];
        const double share = graded.share(size.stretch().elongated(midpoint(p, q)));
        if (share > 0.125 && share < 0.875) continue;
        const std::size_t end = share < 0.5 ? 0 : 1;
        n[end] += 1;
        result.graded_edge[end] += length(q - p);
        result.wanted_edge[end] += edge * size.graded(midpoint(p, q)) * size.mean_edge_of_scatter();
    }
    for (const std::size_t end : {0U, 1U}) {
        if (n[end] == 0) continue;
        result.graded_edge[end] /= n[end];
        result.wanted_edge[end] /= n[end];
    }
    return result;
}

Elongation elongation_of(const PlaneCells& cells) {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const Edge& e : cells.edges) {
        const Point d = cells.points[static_cast<std::size_t>(e[1])] - cells.points[static_cast<std::size_t>(e[0])];
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    const double mean = (xx + yy) / 2;
    const double half_difference = std::hypot((xx - yy) / 2, xy);
    return {std::sqrt((mean + half_difference) / (mean - half_difference)), 0.5 * std::atan2(2 * xy, xx - yy)};
}

}  // namespace graincrack::mesher
