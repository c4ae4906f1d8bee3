#include "post/export/shared_mesh.hpp"

#include <algorithm>

#include "share/base/union_find.hpp"

namespace graincrack {

namespace {

/// The point of each node; adds the points to the mesh.
std::vector<std::int32_t> join_nodes(const Specimen& s, SharedMesh& mesh) {
    UnionFind sets(s.n_nodes());
    for (const auto& [a1, a2, b1, b2] : s.contact_nodes) {
        sets.join(static_cast<std::size_t>(a1), static_cast<std::size_t>(b1));
        sets.join(static_cast<std::size_t>(a2), static_cast<std::size_t>(b2));
    }
    std::vector<std::int32_t> point(s.n_nodes());
    for (std::size_t node = 0; node < s.n_nodes(); ++node) {
        const std::size_t lowest = sets.find(node);
        if (lowest == node) {
            point[node] = static_cast<std::int32_t>(mesh.points.size());
            mesh.points.push_back(s.node_position[node]);
        } else {
            point[node] = point[lowest];
        }
    }
    return point;
}

/// Every name that a side can have: those of the parts, then two for each class of flaws, the first of which is of no class: open
/// boundaries, and cracks.
std::vector<std::string> all_side_names(const Specimen& s) {
    std::vector<std::string> names = s.part_names;
    names.insert(names.end(), {"open-boundary", "crack"});  // other grain boundaries have none
    for (const std::string& flaw : s.flaw_names) names.insert(names.end(), {"flaw-" + flaw, "flaw-" + flaw + "-broken"});
    return names;
}

/// Leaves the names in use; those that are equal become one.
void keep_used_names(SharedMesh& mesh, const std::vector<std::string>& names) {
    std::vector<bool> is_used(names.size(), false);
    for (const NamedSide& side : mesh.sides) is_used[side.name] = true;
    std::vector<std::size_t> kept(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!is_used[i]) continue;
        const auto equal = std::find(mesh.side_names.begin(), mesh.side_names.end(), names[i]);
        kept[i] = static_cast<std::size_t>(equal - mesh.side_names.begin());
        if (equal == mesh.side_names.end()) mesh.side_names.push_back(names[i]);
    }
    for (NamedSide& side : mesh.sides) side.name = kept[side.name];
}

}  // namespace

SharedMesh share_nodes(const Specimen& s) {
    SharedMesh mesh;
    const std::vector<std::int32_t> point = join_nodes(s, mesh);
    const auto point_of = [&](std::int32_t node) { return point[static_cast<std::size_t>(node)]; };
    for (const auto& [i, j, k] : s.element_nodes) mesh.triangles.push_back({point_of(i), point_of(j), point_of(k)});
    mesh.triangle_grain = s.element_grain;
    mesh.grain_phase = s.grain_phase;
    mesh.grain_area = s.grain_area;
    mesh.phase_names = s.phase_names;
    mesh.has_strength_factors = !s.contact_strength_factor.empty();
    mesh.has_crystals = !s.grain_crystal.empty();
    for (std::size_t b = 0; b < s.n_boundary_edges(); ++b) {
        const auto& [from, to] = s.boundary_edges[b];
        mesh.sides.push_back({point_of(from), point_of(to), s.boundary_part[b]});
    }
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const std::size_t flaw = s.contact_flaw.empty() ? 0 : s.contact_flaw[c];
        const bool is_broken = s.contact_kind[c] == static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
        if (flaw == 0 && !starts_broken(s.contact_kind[c])) continue;
        const auto& nodes = s.contact_nodes[c];
        mesh.sides.push_back({point_of(nodes[0]), point_of(nodes[1]), s.part_names.size() + 2 * flaw + (is_broken ? 1 : 0)});
    }
    keep_used_names(mesh, all_side_names(s));
    return mesh;
}

}  // namespace graincrack
