#include "solver/model/prescribed.hpp"

#include <algorithm>

namespace graincrack {

void arrange_drives(const Assemblage& a, Drives& drives) {
    std::sort(drives.nodes.begin(), drives.nodes.end(), [](const DrivenNode& l, const DrivenNode& r) { return l.node < r.node; });
    std::stable_sort(drives.edges.begin(), drives.edges.end(),
                     [](const LoadedEdge& l, const LoadedEdge& r) { return l.nodes < r.nodes; });
    drives.nodes_of_block = ranges_by_block(a, drives.nodes, [](const DrivenNode& n) { return n.node; });
    drives.edges_of_block = ranges_by_block(a, drives.edges, [](const LoadedEdge& e) { return e.nodes[0]; });
}

}  // namespace graincrack
