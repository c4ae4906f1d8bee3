#include "solver/model/vertex_clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "share/error.hpp"
#include "solver/model/memory.hpp"

namespace graincrack {

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

namespace {

constexpr std::int32_t clusters_per_chunk = 32;

/// The lowest of the nodes that share a vertex with each node.
std::vector<std::int32_t> vertex_of_nodes(const Assemblage& a) {
    std::vector<std::int32_t> parent(a.position.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const ContactGeometry& g : a.contacts) {
        for (std::size_t p = 0; p < 2; ++p) {
            const std::int32_t i = root_of(parent, g.nodes[p]);
            const std::int32_t j = root_of(parent, g.nodes[2 + p]);
            parent[std::max(i, j)] = std::min(i, j);
        }
    }
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        parent[i] = root_of(parent, i);
    }
    return parent;
}

/// Cuts a sequence sorted by cluster into one range a cluster.
template <class ClusterOf>
std::vector<Range> ranges_of_clusters(std::int32_t count, std::int32_t n_clusters, ClusterOf&& cluster_of) {
    std::vector<Range> ranges(n_clusters);
    std::int32_t i = 0;
    for (std::int32_t g = 0; g < n_clusters; ++g) {
        ranges[g].begin = i;
        while (i < count && cluster_of(i) == g) {
            ++i;
        }
        ranges[g].end = i;
    }
    return ranges;
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
    std::vector<std::int32_t> place_of_node(a.position.size());
    std::vector<std::int32_t> cluster_of_node(a.position.size());
    std::int32_t n_clusters = 0;
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        const std::int32_t node = m.nodes[i];
        n_clusters += vertex[node] == node ? 1 : 0;  // the lowest node comes first
        place_of_node[node] = i;
        cluster_of_node[node] = n_clusters - 1;
    }
    for (std::int32_t point = 0; point < 2 * a.n_contacts(); ++point) {
        const auto& nodes = a.contacts[point / 2].nodes;
        m.links.push_back({place_of_node[nodes[point % 2]], place_of_node[nodes[2 + point % 2]], point,
                           cluster_reach * 2 * a.contacts[point / 2].point_area});
    }
    const auto cluster_of_link = [&](const MassScaling::Link& link) { return cluster_of_node[m.nodes[link.first]]; };
    std::stable_sort(m.links.begin(), m.links.end(), [&](const MassScaling::Link& l, const MassScaling::Link& r) {
        return cluster_of_link(l) < cluster_of_link(r);
    });
    m.clusters = ranges_of_clusters(a.n_nodes(), n_clusters, [&](std::int32_t i) { return cluster_of_node[m.nodes[i]]; });
    m.links_of_cluster = ranges_of_clusters(static_cast<std::int32_t>(m.links.size()), n_clusters,
                                            [&](std::int32_t t) { return cluster_of_link(m.links[t]); });
    cut_chunks(m);
    for (const std::int32_t node : m.nodes) {
        m.mass.insert(m.mass.end(), 2, a.mass[node]);
        m.inverse_mass.insert(m.inverse_mass.end(), 2, a.inverse_mass[node]);
    }
    return m;
}

std::size_t memory_of(const MassScaling& scaling) {
    const auto& [factor, nodes, links, clusters, links_of_cluster, chunks, mass, inverse_mass] = scaling;
    return memory_of_all(nodes, links, clusters, links_of_cluster, chunks, mass, inverse_mass);
}

std::size_t memory_of(const ClusterState& state) {
    const auto& [linked, supported, constraining_platen, component, inverse_mass, whole, sums, constrained, chunk_of_point,
                 cracked, platen_nodes] = state;
    return memory_of_all(linked, supported, constraining_platen, component, inverse_mass, whole, sums, constrained,
                         chunk_of_point, cracked, platen_nodes);
}

}  // namespace graincrack
