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
        const std::optional<std::size_t> end = graded.end_at(size.stretch().elongated(midpoint(p, q)));
        if (!end) continue;
        n[*end] += 1;
        result.graded_edge[*end] += length(q - p);
        result.wanted_edge[*end] += edge * size.graded(midpoint(p, q)) * size.mean_edge_of_scatter();
    }
    for (const std::size_t end : {0U, 1U}) {
        if (n[end] == 0) continue;
        result.graded_edge[end] /= n[end];
        result.wanted_edge[end] /= n[end];
    }
    return result;
}

}  // namespace graincrack::mesher
