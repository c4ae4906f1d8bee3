#include "solver/model/boundary.hpp"

#include <cmath>

namespace graincrack {
namespace {

/// The boundary as platens with an axis meet it.
struct SpecimenFaces {
    std::vector<bool> has_node;                    ///< [n]
    std::vector<double> facing_length;             ///< [n] half the extent across the axis of the boundary edges at a node, m
    std::vector<std::vector<std::uint8_t>> parts;  ///< [n]
};
SpecimenFaces specimen_faces(const Assemblage& a, const Specimen& s, const Vector2& axis) {
    const std::size_t n = a.position.size();
    SpecimenFaces o{std::vector<bool>(n, false), std::vector<double>(n, 0.0), std::vector<std::vector<std::uint8_t>>(n)};
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        const std::int32_t i = a.node_of_specimen[s.boundary_edges[e][0]];
        const std::int32_t j = a.node_of_specimen[s.boundary_edges[e][1]];
        const double half = 0.5 * std::abs(dot(across(axis), a.position[j] - a.position[i]));
        for (const std::int32_t node : {i, j}) {
            o.has_node[node] = true;
            o.facing_length[node] += half;
            o.parts[node].push_back(s.boundary_part[e]);
        }
    }
    return o;
}

/// True if a face of this extent and these parts may meet a point.
bool is_before(const Platen& platen, const Vector2& position, const std::vector<std::uint8_t>& parts, double slack) {
    const double along = dot(across(platen.axis), position);
    if (!(along >= platen.left - slack && along <= platen.right + slack)) return false;
    return platen.parts.empty() ||
           std::find_first_of(parts.begin(), parts.end(), platen.parts.begin(), platen.parts.end()) != parts.end();
}

}  // namespace

Boundary make_boundary(const Assemblage& a, const Specimen& s, const std::vector<Platen>& platens, double reach) {
    Boundary b;
    b.platens = platens;
    const SpecimenFaces boundary = specimen_faces(a, s, platens.front().axis);
    // A node that stands upright or inside can be met only later, by a corner: it stands for half a mean contact on either side.
    const double corner_tributary = a.n_contacts() == 0 ? 0 : a.contact_length / static_cast<double>(a.n_contacts());
    const double slack = 1e-9 * s.height;
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        for (std::size_t p = 0; p < platens.size(); ++p) {
            const Platen& platen = platens[p];
            if (!is_before(platen, a.position[i], boundary.parts[i], slack)) continue;
            const double gap = platen.side * (dot(platen.axis, a.position[i]) - platen.position);
            const bool outer = boundary.has_node[i];
            const double facing = boundary.facing_length[i];
            const double tributary = facing > 1e-9 * s.width ? facing : corner_tributary;
            // A bonded platen holds the face it is bonded to; a platen may be met by anything near.
            const bool at_face = gap > -slack;
            const bool candidate = platen.bonded ? outer && at_face : gap > -reach;
            if (!candidate) continue;
            b.platen_points.push_back({i, static_cast<std::int32_t>(p), tributary, std::min(gap, 0.0), 0, 0, outer || at_face});
        }
    }
    b.platen_points_of_chunk = ranges_by_chunk(a, b.platen_points, [](const PlatenPoint& point) { return point.node; });
    return b;
}

}  // namespace graincrack
