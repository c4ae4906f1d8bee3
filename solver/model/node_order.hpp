// The order of the nodes: those that contacts link at a vertex of the reference mesh, a vertex cluster, lie near each other.
//
// Clusters follow the grains of the specimen and are cut into chunks. In a chunk the largest clusters come first, and nodes lie
// row by row: the first node of every cluster, then the second of those that have two, and so on. The clusters of a row are the
// first ones of the chunk, so that a sum over the nodes of each cluster is a sum of rows, which are contiguous:
//
//   sum[k] += value[row.begin + k]   for k < row.size()
#pragma once

#include <cstdint>
#include <vector>

#include "share/file/specimen.hpp"
#include "solver/model/range.hpp"

namespace graincrack {

/// Most clusters in a chunk of nodes, and most nodes unless it is one cluster alone.
inline constexpr std::int32_t clusters_per_chunk = 32;
inline constexpr std::int32_t nodes_per_chunk = 256;

/// Nodes that a thread works on at a time: whole clusters.
struct NodeChunk {
    Range nodes;
    Range clusters;
    Range rows;
};

struct NodeOrder {
    std::vector<std::int32_t> node_of_specimen;  ///< [n] internal index of a node of the specimen
    std::vector<NodeChunk> chunks;
    std::vector<Range> rows;                    ///< of nodes
    std::vector<std::int32_t> cluster_of_node;  ///< [n]
};

/// A node that no contact links is a cluster of its own.
NodeOrder order_nodes(const Specimen& specimen);

}  // namespace graincrack
