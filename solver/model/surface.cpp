#include "solver/model/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace graincrack {
namespace {

constexpr std::int32_t none = -1;
constexpr std::int32_t several = -2;

void remember(std::int32_t& place, std::int32_t edge) { place = place == none ? edge : several; }

/// Neighbours along the outline, where a node begins and ends one edge only (where a grain pinches there is no single one).
void link(std::vector<SurfaceEdge>& edges, std::size_t n_nodes) {
    std::vector<std::int32_t> begins(n_nodes, none);
    std::vector<std::int32_t> ends(n_nodes, none);
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(edges.size()); ++e) {
        remember(begins[edges[e].nodes[0]], e);
        remember(ends[edges[e].nodes[1]], e);
    }
    for (SurfaceEdge& edge : edges) {
        edge.previous = std::max(ends[edge.nodes[0]], none);
        edge.next = std::max(begins[edge.nodes[1]], none);
    }
}

}  // namespace

GrainSurface make_surface(const Specimen& s, const std::vector<std::int32_t>& node_of_specimen,
                          const std::vector<std::int32_t>& contact_of_specimen) {
    GrainSurface o;
    const std::size_t n = s.n_nodes();
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    o.grain_of_node.resize(n);
    for (std::size_t i = 0; i < n; ++i) o.grain_of_node[node_of_specimen[i]] = grain[i];
    o.tributary.assign(n, 0.0);
    o.edge_begin.assign(n + 1, 0);
    const auto add = [&](std::int32_t from, std::int32_t to, std::int32_t contact) {
        const SurfaceEdge edge{{node_of_specimen[from], node_of_specimen[to]}, grain[from], contact, none, none};
        const double edge_length =
            std::hypot(s.node_position[to][0] - s.node_position[from][0], s.node_position[to][1] - s.node_position[from][1]);
        o.mean_length += edge_length;
        for (const std::int32_t node : edge.nodes) {
            o.tributary[node] += 0.25 * edge_length;
            ++o.edge_begin[node + 1];
        }
        o.edges.push_back(edge);
    };
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto& nodes = s.contact_nodes[c];
        add(nodes[0], nodes[1], contact_of_specimen[c]);
        add(nodes[3], nodes[2], contact_of_specimen[c]);
    }
    for (const auto& edge : s.boundary_edges) add(edge[0], edge[1], none);
    o.mean_length /= static_cast<double>(std::max<std::size_t>(o.edges.size(), 1));
    link(o.edges, n);
    std::partial_sum(o.edge_begin.begin(), o.edge_begin.end(), o.edge_begin.begin());
    o.edges_of_node.resize(2 * o.edges.size());
    std::vector<std::int32_t> at(o.edge_begin.begin(), o.edge_begin.end() - 1);
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(o.edges.size()); ++e) {
        for (const std::int32_t node : o.edges[e].nodes) o.edges_of_node[at[node]++] = e;
    }
    return o;
}

}  // namespace graincrack
