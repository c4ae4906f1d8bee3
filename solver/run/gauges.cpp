#include "solver/run/gauges.hpp"

#include <algorithm>
#include <cmath>

#include "share/file/specimen_measures.hpp"

namespace graincrack {
namespace {

/// Least-squares slope of one displacement component over the same coordinate.
Gauge slope_gauge(const Assemblage& a, bool along_y, const std::vector<std::int32_t>& nodes) {
    const auto coordinate = [&](std::int32_t i) { return along_y ? a.position[i].y : a.position[i].x; };
    double mean = 0;
    for (const std::int32_t i : nodes) mean += coordinate(i);
    mean /= static_cast<double>(std::max<std::size_t>(nodes.size(), 1));
    double square = 0;
    for (const std::int32_t i : nodes) square += (coordinate(i) - mean) * (coordinate(i) - mean);
    Gauge gauge{along_y, {}, {}};
    if (square > 0) {
        for (const std::int32_t i : nodes) gauge.terms.push_back({i, (coordinate(i) - mean) / square});
    }
    return gauge;
}

void cut_terms(const Assemblage& a, Gauge& gauge) {
    std::sort(gauge.terms.begin(), gauge.terms.end(), [](const Gauge::Term& l, const Gauge::Term& r) { return l.node < r.node; });
    gauge.of_chunk = ranges_by_chunk(a, gauge.terms, [](const Gauge::Term& term) { return term.node; });
}

/// Nodes of the lateral boundary: side −1 left, +1 right.
std::vector<std::int32_t> lateral_nodes(const Assemblage& a, const Specimen& s, double side) {
    constexpr double tan_15_degrees = 0.2679491924311227;
    const auto part = static_cast<std::uint8_t>(side < 0 ? BoundaryPart::left : BoundaryPart::right);
    std::vector<std::int32_t> nodes;
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        for (const std::int32_t specimen_node : s.boundary_edges[e]) {
            const std::int32_t i = a.node_of_specimen[specimen_node];
            const Vector2& p = a.position[i];
            const bool near_axis = s.boundary_part[e] == static_cast<std::uint8_t>(BoundaryPart::rim) && side * p.x > 0 &&
                                   std::abs(p.y) <= tan_15_degrees * std::abs(p.x);
            if (s.boundary_part[e] == part || near_axis) nodes.push_back(i);
        }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace

double Gauge::strain_of(std::int32_t chunk, const std::vector<Vector2>& displacement) const {
    return sum_over(of_chunk[chunk], [&](std::int32_t i) {
        const Vector2& u = displacement[terms[i].node];
        return terms[i].weight * (along_y ? u.y : u.x);
    });
}

GaugeStrains Gauges::strains(const Assemblage& a, const std::vector<Vector2>& displacement) const {
    return sum_over_chunks(a.part, a.part.nodes, [&](std::int32_t chunk) {
        return GaugeStrains{axial.strain_of(chunk, displacement), lateral.strain_of(chunk, displacement),
                            widening.strain_of(chunk, displacement)};
    });
}

Gauges make_gauges(const Assemblage& a, const Specimen& s) {
    const bool has_faces = has_end_faces(s);
    std::vector<std::int32_t> central;
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        const Vector2& p = a.position[i];
        if (std::abs(p.y) <= s.height / 4 && (has_faces || std::abs(p.x) <= s.width / 4)) central.push_back(i);
    }
    Gauges gauges{slope_gauge(a, true, central), slope_gauge(a, false, central), {}};
    for (const double side : {-1.0, 1.0}) {
        const std::vector<std::int32_t> nodes = lateral_nodes(a, s, side);
        for (const std::int32_t i : nodes) {
            gauges.widening.terms.push_back({i, side / (static_cast<double>(nodes.size()) * s.width)});
        }
    }
    for (Gauge* gauge : {&gauges.axial, &gauges.lateral, &gauges.widening}) cut_terms(a, *gauge);
    return gauges;
}

}  // namespace graincrack
