#include "solver/model/vertex_clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "share/error.hpp"
#include "solver/model/memory.hpp"

namespace graincrack {

namespace {

constexpr std::int32_t clusters_per_chunk = 32;

/// Representative of `i` in a forest of parents, with the path to it shortened.
std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

/// The lowest of the nodes that share a vertex with each node.
std::vector<std::int32_t> vertex_of_nodes(const Assemblage& a) {
    std::vector<std::int32_t> parent(a.position.size());
    std::iota(parent.begin(), parent.end(), 0);
    for_each_contact(a, [&](std::int32_t c, std::int32_t /*contact_class*/) {
        const auto& nodes = a.contacts[c].nodes;
        for (std::size_t p = 0; p < 2; ++p) {
            const std::int32_t i = root_of(parent, nodes[p]);
            const std::int32_t j = root_of(parent, nodes[2 + p]);
            parent[std::max(i, j)] = std::min(i, j);
        }
    });
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        parent[i] = root_of(parent, i);
    }
    return parent;
}

/// Cuts clusters into chunks.
void cut_chunks(MassScaling& m) {
    for (std::int32_t g = 0; g < static_cast<std::int32_t>(m.clusters.size()); ++g) {
        if (m.clusters[g].size() > nodes_per_chunk) {
            throw InputError(fmt::format("{} nodes meet at one vertex; mass scaling can take {}: use --mass-scaling none",
                                         m.clusters[g].size(), nodes_per_chunk));
        }
        const bool fits = !m.chunks.empty() && m.chunks.back().size() < clusters_per_chunk &&
                          m.clusters[g].end - m.clusters[m.chunks.back().begin].begin <= nodes_per_chunk;
        if (fits) {
            m.chunks.back().end = g + 1;
        } else {
            m.chunks.push_back({g, g + 1});
        }
    }
}

}  // namespace

MassScaling make_mass_scaling(const Assemblage& a, double factor) {
    MassScaling m;
    m.factor = factor;
    if (!m.is_on()) {
        return m;
    }
    const std::vector<std::int32_t> vertex = vertex_of_nodes(a);
    m.nodes.resize(a.position.size());
    std::iota(m.nodes.begin(), m.nodes.end(), 0);
    std::stable_sort(m.nodes.begin(), m.nodes.end(), [&](std::int32_t i, std::int32_t j) { return vertex[i] < vertex[j]; });
    m.cluster_of_node.resize(a.position.size());
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        const std::int32_t node = m.nodes[i];
        if (vertex[node] == node) {  // the lowest node comes first
            m.clusters.push_back({i, i});
            m.cluster_mass.push_back(0);
        }
        ++m.clusters.back().end;
        m.cluster_mass.back() += a.mass[node];
        m.cluster_of_node[node] = static_cast<std::int32_t>(m.clusters.size()) - 1;
    }
    cut_chunks(m);
    for (const std::int32_t node : m.nodes) {
        m.mass.insert(m.mass.end(), 2, a.mass[node]);
        m.inverse_mass.insert(m.inverse_mass.end(), 2, a.inverse_mass[node]);
    }
    return m;
}

std::size_t memory_of(const MassScaling& scaling) {
    const auto& [factor, nodes, clusters, chunks, mass, inverse_mass, cluster_of_node, cluster_mass] = scaling;
    return memory_of_all(nodes, clusters, chunks, mass, inverse_mass, cluster_of_node, cluster_mass);
}

std::size_t memory_of(const ClusterState& state) {
    const auto& [near_platen, sums, constraining_platen, inverse_mass, constrained, platen_nodes] = state;
    return memory_of_all(near_platen, sums, constraining_platen, inverse_mass, constrained, platen_nodes);
}

}  // namespace graincrack
