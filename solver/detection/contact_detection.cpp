#include "solver/detection/contact_detection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/pair_geometry.hpp"
#include "solver/detection/stable_area.hpp"

namespace graincrack {
namespace {

using namespace detection_rule;

/// Over the mean edge: a node less far behind a bonded edge is in the bond, not in the grain.
constexpr double bond_width = 3e-3;
/// Least area of a contact where many meet, over the tributary area of its node.
constexpr double min_area = 0.1;
/// Cosine of the angle between two normals above which two edges are of one surface.
constexpr double aligned = 0.5;
/// Sine of a turn of the surface beyond which its two edges are two faces.
constexpr double corner = 0.05;

/// Data of detection in a chunk of watched pairs.
struct Chunk {
    const Assemblage& assemblage;
    const StepParameters& parameters;
    State& state;
    PairGeometries& geometry;  ///< by place among the chunk's watched pairs
    std::int32_t index;
    double friction = 0;
};

/// Prefetches the contacts of the watched pairs of a chunk, which are scattered in a long list.
void prefetch(const ContactPairList& list, Range watched) {
    for (std::int32_t i = watched.begin; i < watched.end; ++i) {
        const auto pair = static_cast<std::size_t>(list.watched[i]);
        __builtin_prefetch(&list.contacts[pair]);
        __builtin_prefetch(&list.contacts[pair].release_correction);
    }
}

/// The watched pairs of one node.
struct Group {
    Chunk& chunk;
    Range watched;
    std::int32_t origin;  ///< first watched pair of the chunk

    [[nodiscard]] std::int32_t size() const { return watched.size(); }
    [[nodiscard]] std::int32_t at(std::int32_t i) const { return watched.begin - origin + i; }
    [[nodiscard]] std::int32_t pair(std::int32_t i) const { return chunk.state.contact_pairs.watched[watched.begin + i]; }
    [[nodiscard]] std::int32_t edge_index(std::int32_t i) const { return chunk.state.contact_pairs.pairs[pair(i)].edge; }
    [[nodiscard]] const SurfaceEdge& edge(std::int32_t i) const { return chunk.assemblage.surface.edges[edge_index(i)]; }
    [[nodiscard]] NodeEdgeContact& contact(std::int32_t i) const { return chunk.state.contact_pairs.contacts[pair(i)]; }
    [[nodiscard]] Vector2* forces(std::int32_t i) const {
        return &chunk.state.contact_pairs.forces[3 * static_cast<std::size_t>(pair(i))];
    }
    [[nodiscard]] std::int32_t node() const { return chunk.state.contact_pairs.pairs[pair(0)].node; }
    [[nodiscard]] PairGeometry geometry(std::int32_t i) const { return chunk.geometry[at(i)]; }
    [[nodiscard]] double depth(std::int32_t i) const { return chunk.geometry.depth(at(i)); }
};

bool is_over(const PairGeometry& g, double beyond) { return g.place >= -beyond && g.place <= 1 + beyond; }

/// Of the two edges next to edge `i` around a convex corner of the grain, the one to whose face the node is nearest, if nearer
/// than `depth` (m); −1 if there is none among the watched pairs.
std::int32_t nearer_face(const Group& group, std::int32_t i, double depth) {
    const SurfaceEdge& edge = group.edge(i);
    const Vector2 t = group.geometry(i).tangent;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < group.size(); ++k) {
        const std::int32_t index = group.edge_index(k);
        if (index != edge.previous && index != edge.next) {
            continue;
        }
        const Vector2 other = group.geometry(k).tangent;
        const double turn = t.x * other.y - t.y * other.x;
        const bool convex = index == edge.next ? turn > corner : turn < -corner;
        if (convex && !group.contact(k).active && group.depth(k) < depth) {
            depth = group.depth(k);
            found = k;
        }
    }
    return found;
}

/// The edge on which the contact of a node that has left edge `i` at its end continues: the one of the same surface whose depth
/// differs least; −1 for none.
std::int32_t next_edge(const Group& group, std::int32_t i) {
    const PairGeometry from = group.geometry(i);
    double nearest = slack / from.inv_length;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < group.size(); ++k) {
        const PairGeometry g = group.geometry(k);
        const double step = std::abs(g.depth - from.depth);
        if (k != i && !group.contact(k).active && is_over(g, slack) && dot(g.normal, from.normal) > aligned && step < nearest) {
            nearest = step;
            found = k;
        }
    }
    return found;
}

/// Removes a contact and its forces.
void clear(Group& group, std::int32_t i) {
    group.contact(i) = NodeEdgeContact{};
    std::fill_n(group.forces(i), 3, Vector2{});
}

/// Ends a contact as its node slips off; the energy of its springs is lost and booked as friction.
void end_contact(Group& group, std::int32_t i) {
    group.chunk.friction += node_edge_energy(group.chunk.parameters.law, group.contact(i));
    clear(group, i);
}

/// Transfers a contact to edge `to` with its force and energy.
void transfer_to_adjacent_edge(Group& group, std::int32_t from, std::int32_t to) {
    NodeEdgeContact contact = group.contact(from);
    contact.initial_overlap = group.depth(to) - contact.overlap;
    group.contact(to) = contact;
    clear(group, from);
}

/// The edge on which contact `i` continues; −1 if it ends.
std::int32_t continue_contact(Group& group, std::int32_t i) {
    std::int32_t on = i;
    if (const std::int32_t face = nearer_face(group, i, group.depth(i) - group.contact(i).initial_overlap); face >= 0) {
        on = group.depth(face) > 0 ? face : -1;
    } else if (!is_over(group.geometry(i), slack)) {
        on = next_edge(group, i);
    }
    if (on < 0) {
        end_contact(group, i);
    } else if (on != i) {
        transfer_to_adjacent_edge(group, i, on);
    }
    return on;
}

/// Decides how the contacts of a node continue; those that do become active.
void continue_contacts(Group& group) {
    std::array<std::int32_t, 16> active{};
    std::size_t count = 0;
    for (std::int32_t i = 0; i < group.size(); ++i) {
        NodeEdgeContact& contact = group.contact(i);
        if (contact.active && count < active.size()) {
            active[count++] = i;
        } else if (!contact.active && contact.release_correction != 0) {
            clear(group, i);
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (const std::int32_t on = continue_contact(group, active[k]); on >= 0) {
            append_active(group.chunk.assemblage.surface, group.chunk.index, group.pair(on), group.chunk.state.contact_pairs);
        }
    }
}

/// The area that is still available at a node: that of its bonds at the start, for which the stable step was found, less the area
/// that its bonds and node–edge contacts occupy now. Without this limit many corners at one end of an edge would be stiffer
/// together than any bond was.
double available_area(const GrainSurface& surface, const std::vector<ContactGeometry>& contacts, const ContactPairList& list,
                      std::int32_t node) {
    double area = 2 * surface.tributary[node] - list.occupied_area[node];
    for (std::int32_t k = surface.edge_begin[node]; k < surface.edge_begin[node + 1]; ++k) {
        const std::int32_t contact = surface.edges[surface.edges_of_node[k]].contact;
        area -= contact >= 0 && list.released[contact] == 0 ? contacts[contact].point_area : 0.0;
    }
    return area;
}

/// Area of a new contact: the tributary area of the node, or less where other contacts already occupy the node or the end of the
/// edge.
double area_of(const Group& group, std::int32_t i) {
    const Assemblage& a = group.chunk.assemblage;
    const auto available = [&](std::int32_t node) {
        return available_area(a.surface, a.contacts, group.chunk.state.contact_pairs, node);
    };
    const double tributary = a.surface.tributary[group.node()];
    const std::int32_t end = group.edge(i).nodes[group.geometry(i).place < 0.5 ? 0 : 1];
    const double of_bonds = std::clamp(std::min(available(group.node()), available(end)), min_area * tributary, tributary);
    const Chunk& chunk = group.chunk;
    const ContactPairList& list = chunk.state.contact_pairs;
    return std::min(of_bonds, stable_area(a, chunk.parameters, list, list.pairs[group.pair(i)], group.geometry(i).place));
}

/// Whether a contact may begin: the node is inside the grain, came in through this edge, and has no other contact with this grain
/// or with the same surface.
bool may_begin(const Group& group, std::int32_t i) {
    const PairGeometry g = group.geometry(i);
    if (group.contact(i).active || g.depth <= 0 || !is_over(g, 0)) {
        return false;
    }
    const bool is_deep = g.depth > deep * group.chunk.assemblage.surface.mean_length;
    if (!is_deep && !is_over(g, -corner_zone)) {
        return false;
    }
    for (std::int32_t k = 0; k < group.size(); ++k) {
        if (group.contact(k).active &&
            (group.edge(k).grain == group.edge(i).grain || (!is_deep && dot(group.geometry(k).normal, g.normal) > aligned))) {
            return false;
        }
    }
    return !came_through_neighbour(group.chunk.assemblage, group.chunk.state,
                                   group.chunk.state.contact_pairs.pairs[group.pair(i)], g, 0);
}

void begin_contacts(Group& group) {
    for (std::int32_t i = 0; i < group.size(); ++i) {
        if (may_begin(group, i)) {
            const PairGeometry g = group.geometry(i);
            group.contact(i) = {true, g.place < 0.5, area_of(group, i), g.depth, 0, 0, 0};
            append_active(group.chunk.assemblage.surface, group.chunk.index, group.pair(i), group.chunk.state.contact_pairs);
        }
    }
}

/// Whether an edge belongs to a contact that has not been released and is not one of the node.
bool is_between_others(const Assemblage& a, const State& s, std::int32_t node, const SurfaceEdge& edge) {
    if (edge.contact < 0 || s.contact_pairs.released[edge.contact] != 0) {
        return false;
    }
    const auto& nodes = a.contacts[edge.contact].nodes;
    return std::find(nodes.begin(), nodes.end(), node) == nodes.end();
}

}  // namespace

bool came_through_neighbour(const Assemblage& a, const State& s, const CandidatePair& pair, const PairGeometry& g,
                            double margin) {
    const SurfaceEdge& edge = a.surface.edges[pair.edge];
    for (const std::int32_t index : {edge.previous, edge.next}) {
        if (index < 0) {
            continue;
        }
        const SurfaceEdge& neighbour = a.surface.edges[index];
        const PairGeometry other = pair_geometry(a, s, CandidatePair{pair.node, index});
        const double turn = g.tangent.x * other.tangent.y - g.tangent.y * other.tangent.x;
        const bool convex = index == edge.next ? turn > corner : turn < -corner;
        const double front =
            is_between_others(a, s, pair.node, neighbour) ? std::min(g.depth, bond_width * a.surface.mean_length) : g.depth;
        if (convex && other.depth < front - margin) {
            return true;
        }
    }
    return false;
}

void detect_contacts(const Assemblage& a, const StepParameters& parameters, std::int32_t index, State& s) {
    ContactPairList& list = s.contact_pairs;
    const Range groups = list.chunks[index];
    const std::int32_t origin = list.first_watched(index);
    const std::int32_t count = list.watched_groups[groups.end - 1].end - origin;
    prefetch(list, {origin, origin + count});
    store_active(index, list);
    static thread_local PairGeometries geometry;
    Chunk chunk{a, parameters, s, geometry, index};
    geometry.find(a, s, count, [&](std::int32_t i) { return list.watched[origin + i]; });
    const auto for_groups = [&](auto&& act) {
        for (std::int32_t i = groups.begin; i < groups.end; ++i) {
            Group group{chunk, list.watched_groups[i], origin};
            act(group);
        }
    };
    const std::int32_t before = list.active.count[index];
    list.active.count[index] = 0;
    list.active.changed[index] = 0;
    for_groups(continue_contacts);
    move_active_contacts(a, parameters, index, s);
    store_active(index, list);
    for_groups(begin_contacts);
    list.active.changed[index] = list.active.changed[index] != 0 || list.active.count[index] != before ? 1 : 0;
    list.friction[index] += chunk.friction;
}

}  // namespace graincrack
