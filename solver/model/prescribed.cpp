#include "solver/model/prescribed.hpp"

#include <algorithm>

namespace graincrack {

void arrange_prescribed(const Assemblage& a, PrescribedConditions& prescribed) {
    std::sort(prescribed.nodes.begin(), prescribed.nodes.end(),
              [](const PrescribedNode& l, const PrescribedNode& r) { return l.node < r.node; });
    std::stable_sort(prescribed.edges.begin(), prescribed.edges.end(),
                     [](const LoadedEdge& l, const LoadedEdge& r) { return l.nodes < r.nodes; });
    prescribed.nodes_of_chunk = ranges_by_chunk(a, prescribed.nodes, [](const PrescribedNode& n) { return n.node; });
    prescribed.edges_of_chunk = ranges_by_chunk(a, prescribed.edges, [](const LoadedEdge& e) { return e.nodes[0]; });
    prescribed.ends.clear();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(prescribed.edges.size()); ++i) {
        for (const std::int32_t node : prescribed.edges[i].nodes) prescribed.ends.push_back({node, i});
    }
    std::stable_sort(prescribed.ends.begin(), prescribed.ends.end(),
                     [](const LoadedEnd& l, const LoadedEnd& r) { return l.node < r.node; });
    prescribed.ends_of_chunk = ranges_by_chunk(a, prescribed.ends, [](const LoadedEnd& e) { return e.node; });
}

}  // namespace graincrack
