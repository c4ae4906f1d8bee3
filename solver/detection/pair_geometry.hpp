// Positions of the nodes of many pairs relative to their edges: gathered one by one, computed side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/arithmetic/simd.hpp"
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

/// Geometry of many pairs.
class PairGeometries {
public:
    /// Finds the geometry of `count` pairs in the present displacements.
    /// \param pair_at (i): the pair's index in the list
    template <class PairAt>
    void find(const Assemblage& a, const State& s, std::int32_t count, PairAt&& pair_at) {
        make_room(static_cast<std::size_t>(count));
        const Vector2* const position = a.position.data();
        const Vector2* const displacement = s.displacement.data();
        const CandidatePair* const pairs = s.contact_pairs.pairs.data();
        const SurfaceEdge* const edges = a.surface.edges.data();
        for (std::int32_t i = 0; i < count; ++i) {
            const CandidatePair pair = pairs[pair_at(i)];
            const auto [first, second] = edges[pair.edge].nodes;
            const Vector2 on_first = position[first] + displacement[first];
            const Vector2 along = (position[second] + displacement[second]) - on_first;
            const Vector2 from_first = (position[pair.node] + displacement[pair.node]) - on_first;
            along_x_[i] = along.x;
            along_y_[i] = along.y;
            from_x_[i] = from_first.x;
            from_y_[i] = from_first.y;
        }
        run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { compute(count); });
    }
    [[nodiscard]] PairGeometry operator[](std::size_t i) const {
        const Vector2 t{tangent_x_[i], tangent_y_[i]};
        return {t, {t.y, -t.x}, inv_length_[i], place_[i], depth_[i]};
    }
    [[nodiscard]] double depth(std::size_t i) const { return depth_[i]; }

private:
    void make_room(std::size_t count) {
        for (auto* values :
             {&along_x_, &along_y_, &from_x_, &from_y_, &tangent_x_, &tangent_y_, &inv_length_, &place_, &depth_}) {
            if (values->size() < count) values->resize(count);
        }
    }
    GRAINCRACK_INLINE void compute(std::int32_t count) {
        const double* const along_x = along_x_.data();
        const double* const along_y = along_y_.data();
        const double* const from_x = from_x_.data();
        const double* const from_y = from_y_.data();
        double* __restrict const tangent_x = tangent_x_.data();
        double* __restrict const tangent_y = tangent_y_.data();
        double* __restrict const inv_length = inv_length_.data();
        double* __restrict const place = place_.data();
        double* __restrict const depth = depth_.data();
        for (std::int32_t i = 0; i < count; ++i) {
            const PairGeometry g = pair_geometry({along_x[i], along_y[i]}, {from_x[i], from_y[i]});
            tangent_x[i] = g.tangent.x;
            tangent_y[i] = g.tangent.y;
            inv_length[i] = g.inv_length;
            place[i] = g.place;
            depth[i] = g.depth;
        }
    }
    std::vector<double> along_x_, along_y_, from_x_, from_y_;
    std::vector<double> tangent_x_, tangent_y_, inv_length_, place_, depth_;
};

}  // namespace graincrack
