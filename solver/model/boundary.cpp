#include "solver/model/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "solver/model/memory.hpp"

namespace graincrack {
namespace {

/// The boundary as a horizontal platen meets it.
struct SpecimenFaces {
    std::vector<bool> has_node;         ///< [n]
    std::vector<double> facing_length;  ///< [n] half the horizontal extent of the boundary edges at a node, m
};
SpecimenFaces specimen_faces(const Assemblage& a, const Specimen& s) {
    SpecimenFaces o{std::vector<bool>(a.position.size(), false), std::vector<double>(a.position.size(), 0.0)};
    for (const auto& edge : s.boundary_edges) {
        const std::int32_t i = a.node_of_specimen[edge[0]];
        const std::int32_t j = a.node_of_specimen[edge[1]];
        const double half = 0.5 * std::abs(a.position[j].x - a.position[i].x);
        for (const std::int32_t node : {i, j}) {
            o.has_node[node] = true;
            o.facing_length[node] += half;
        }
    }
    return o;
}

}  // namespace

Boundary make_boundary(const Assemblage& a, const Specimen& s, const std::array<Platen, 2>& platens, double reach) {
    Boundary b;
    b.platens = platens;
    const SpecimenFaces boundary = specimen_faces(a, s);
    // What stands upright or inside can be met only later, by a corner: it stands for half a mean contact on either side.
    const double corner_tributary = a.n_contacts() == 0 ? 0 : a.contact_length / static_cast<double>(a.n_contacts());
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        for (std::int32_t p = 0; p < 2; ++p) {
            const double gap = platens[p].side * (a.position[i].y - platens[p].position);
            const bool outer = boundary.has_node[i];
            const double facing = boundary.facing_length[i];
            const double tributary = facing > 1e-9 * s.width ? facing : corner_tributary;
            // A bonded platen holds the face it is bonded to; a platen may be met by anything near.
            const bool at_face = gap > -1e-9 * s.height;
            const bool candidate = platens[p].bonded ? outer && at_face : gap > -reach;
            if (candidate) b.platen_points.push_back({i, p, tributary, std::min(gap, 0.0), 0, 0, outer || at_face});
        }
    }
    b.platen_points_of_chunk = ranges_by_chunk(a, b.platen_points, [](const PlatenPoint& point) { return point.node; });
    return b;
}

std::size_t memory_of(const Boundary& boundary) {
    const auto& [platens, platen_points, platen_points_of_chunk, prescribed] = boundary;
    return memory_of_all(platen_points, platen_points_of_chunk, prescribed);
}

std::size_t memory_of(const StepLoading& loading) {
    const auto& [platen_displacement, increment_before, increment_after, amplitudes] = loading;
    return memory_of_all(amplitudes);
}

}  // namespace graincrack
