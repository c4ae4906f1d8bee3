// Present positions of nodes, and of the nodes of pairs relative to their edges.
#pragma once

#include <algorithm>
#include <cstdint>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// An upright rectangle, at first around nothing.
struct Rectangle {
    Vector2 low{1e300, 1e300}, high{-1e300, -1e300};
    void include(const Vector2& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    [[nodiscard]] bool contains(const Vector2& p, double margin = 0) const {
        return p.x >= low.x - margin && p.x <= high.x + margin && p.y >= low.y - margin && p.y <= high.y + margin;
    }
};

/// Present position of a node, m.
inline Vector2 position_of(const Assemblage& a, const State& s, std::int32_t node) {
    return a.position[node] + s.displacement[node];
}
/// Geometry of one pair in the present displacements.
inline PairGeometry pair_geometry(const Assemblage& a, const State& s, const CandidatePair& pair) {
    const auto [first, second] = a.surface.edges[pair.edge].nodes;
    return pair_geometry(position_of(a, s, pair.node), position_of(a, s, first), position_of(a, s, second));
}

}  // namespace graincrack
