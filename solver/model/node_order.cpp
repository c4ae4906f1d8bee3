#include "solver/model/node_order.hpp"

#include <algorithm>
#include <numeric>

#include "share/base/union_find.hpp"

namespace graincrack {
namespace {

/// Nodes sorted by grain.
std::vector<std::int32_t> nodes_by_grain(const Specimen& s) {
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    std::vector<std::int32_t> order(s.n_nodes());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&grain](std::int32_t i, std::int32_t j) {
        return static_cast<std::uint32_t>(grain[i]) < static_cast<std::uint32_t>(grain[j]);
    });
    return order;
}

/// The clusters, each with its nodes in the order of the grains, in the order of their first nodes.
std::vector<std::vector<std::int32_t>> find_clusters(const Specimen& s) {
    const std::vector<std::int32_t> by_grain = nodes_by_grain(s);
    std::vector<std::int32_t> place(by_grain.size());
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(by_grain.size()); ++i) place[by_grain[i]] = i;
    UnionFind sets(by_grain.size());
    for (const auto& nodes : s.contact_nodes) {
        for (std::size_t p = 0; p < 2; ++p) {
            sets.join(static_cast<std::size_t>(place[nodes[p]]), static_cast<std::size_t>(place[nodes[2 + p]]));
        }
    }
    std::vector<std::vector<std::int32_t>> clusters;
    std::vector<std::size_t> cluster_of_root(by_grain.size());
    for (std::size_t i = 0; i < by_grain.size(); ++i) {
        const std::size_t root = sets.find(i);
        if (root == i) {  // the first node of a cluster
            cluster_of_root[i] = clusters.size();
            clusters.emplace_back();
        }
        clusters[cluster_of_root[root]].push_back(by_grain[i]);
    }
    return clusters;
}

/// Cuts clusters into chunks.
std::vector<Range> cut_chunks(const std::vector<std::vector<std::int32_t>>& clusters) {
    std::vector<Range> chunks;
    std::int32_t n_nodes = 0;  // in the last chunk
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(clusters.size()); ++i) {
        const auto size = static_cast<std::int32_t>(clusters[i].size());
        if (!chunks.empty() && chunks.back().size() < clusters_per_chunk && n_nodes + size <= nodes_per_chunk) {
            ++chunks.back().end;
            n_nodes += size;
        } else {
            chunks.push_back({i, i + 1});
            n_nodes = size;
        }
    }
    return chunks;
}

}  // namespace

NodeOrder order_nodes(const Specimen& s) {
    std::vector<std::vector<std::int32_t>> clusters = find_clusters(s);
    NodeOrder o;
    o.node_of_specimen.resize(s.n_nodes());
    o.cluster_of_node.resize(s.n_nodes());
    std::int32_t node = 0;
    for (const Range chunk : cut_chunks(clusters)) {
        std::stable_sort(clusters.begin() + chunk.begin, clusters.begin() + chunk.end,
                         [](const auto& l, const auto& r) { return l.size() > r.size(); });
        const std::int32_t first_node = node;
        const auto first_row = static_cast<std::int32_t>(o.rows.size());
        for (std::size_t row = 0; row < clusters[chunk.begin].size(); ++row) {
            const std::int32_t begin = node;
            for (std::int32_t i = chunk.begin; i < chunk.end && row < clusters[i].size(); ++i) {
                o.cluster_of_node[node] = i;
                o.node_of_specimen[clusters[i][row]] = node++;
            }
            o.rows.push_back({begin, node});
        }
        o.chunks.push_back({{first_node, node}, chunk, {first_row, static_cast<std::int32_t>(o.rows.size())}});
    }
    return o;
}

}  // namespace graincrack
