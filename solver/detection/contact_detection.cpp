#include "solver/detection/contact_detection.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/pair_geometry.hpp"
#include "solver/detection/stable_area.hpp"

namespace graincrack {
namespace {

// The numbers of this list were chosen by trial and not varied since.

/// Distance behind a bonded edge, in mean edge lengths, up to which a node lies in the bond and not in the grain. With a larger
/// one nodes slip farther in along a bond before a contact stops them; with a smaller one nodes that only lie in the bond begin
/// contacts with the grains at either side of it.
constexpr double bond_width = 3e-3;
/// Area that marks a new contact until `find_areas_of_new_contacts`.
constexpr double area_not_found = 0;
/// Smallest area of a new contact, over the tributary area of its node. It may exceed the available area, by this fraction at
/// most per contact, because a node without any area would not be kept out.
constexpr double min_area = 0.1;
/// Two edges are of one surface if the cosine of the angle between their normals is larger. Edges turned by less than 60° push a
/// node the same way, and one contact is enough.
constexpr double cos_same_surface = 0.5;
/// Two edges form a corner with two faces if the outline of the grain turns between them by an angle with a larger sine. A
/// smaller turn (3°) is the unevenness of one face, along which a contact is transferred at the ends of the edges only.
constexpr double sin_corner = 0.05;

/// Memory of a thread, kept from chunk to chunk.
struct Scratch {
    std::vector<PairGeometry> geometry;  ///< of the chunk's watched pairs
    std::vector<std::int32_t> active;    ///< the pairs of a node that are in contact
};

/// Data of detection in a chunk of watched pairs.
struct ChunkData {
    const Assemblage& assemblage;
    const StepParameters& parameters;
    State& state;
    Scratch& scratch;
    std::int32_t chunk;
    double friction = 0;
};

/// The watched pairs of one node, `i` from 0 to `size()`.
struct NodePairs {
    ChunkData& data;
    Range in_watched;          ///< their indices in `ContactPairList::watched`
    std::int32_t chunk_begin;  ///< index there of the first pair of the chunk

    [[nodiscard]] std::int32_t size() const { return in_watched.size(); }
    [[nodiscard]] std::int32_t index_in_list(std::int32_t i) const {
        return data.state.contact_pairs.watched[in_watched.begin + i];
    }
    [[nodiscard]] const CandidatePair& pair(std::int32_t i) const { return data.state.contact_pairs.pairs[index_in_list(i)]; }
    [[nodiscard]] const SurfaceEdge& edge(std::int32_t i) const { return data.assemblage.surface.edges[pair(i).edge]; }
    [[nodiscard]] NodeEdgeContact& contact(std::int32_t i) const { return data.state.contact_pairs.contacts[index_in_list(i)]; }
    [[nodiscard]] Vector2* forces(std::int32_t i) const {
        return &data.state.contact_pairs.forces[3 * static_cast<std::size_t>(index_in_list(i))];
    }
    [[nodiscard]] std::int32_t node() const { return pair(0).node; }
    [[nodiscard]] const PairGeometry& geometry(std::int32_t i) const {
        return data.scratch.geometry[in_watched.begin - chunk_begin + i];
    }
    [[nodiscard]] double depth(std::int32_t i) const { return geometry(i).depth; }
};

/// True if a node is over an edge lengthened by `extension` (of its length) at either end.
bool is_over(const PairGeometry& g, double extension) { return g.place >= -extension && g.place <= 1 + extension; }

/// True if the outline of a grain has a convex corner between an edge and the next one, or the previous one.
bool is_convex_corner(const Vector2& tangent, const Vector2& neighbour_tangent, bool neighbour_is_next) {
    const double turn = tangent.x * neighbour_tangent.y - tangent.y * neighbour_tangent.x;
    return neighbour_is_next ? turn > sin_corner : turn < -sin_corner;
}

/// Of the two edges next to edge `i` around a convex corner of the grain, returns the watched pair whose face is nearest to the
/// node, if nearer than `depth` (m); −1 if there is none.
std::int32_t nearer_face(const NodePairs& pairs, std::int32_t i, double depth) {
    const SurfaceEdge& edge = pairs.edge(i);
    const Vector2 tangent = pairs.geometry(i).tangent;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < pairs.size(); ++k) {
        const std::int32_t neighbour = pairs.pair(k).edge;
        if (neighbour != edge.previous && neighbour != edge.next) continue;
        if (is_convex_corner(tangent, pairs.geometry(k).tangent, neighbour == edge.next) && !pairs.contact(k).active &&
            pairs.depth(k) < depth) {
            depth = pairs.depth(k);
            found = k;
        }
    }
    return found;
}

/// The edge on which the contact of a node continues that has left edge `i` at its end. It is the edge of the same surface, of
/// any grain, whose depth differs least, and by less than `end_tolerance` of edge `i`; −1 if there is none.
std::int32_t next_edge(const NodePairs& pairs, std::int32_t i) {
    const PairGeometry from = pairs.geometry(i);
    double min_change = detection_rule::end_tolerance / from.inv_length;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < pairs.size(); ++k) {
        const PairGeometry to = pairs.geometry(k);
        const double depth_change = std::abs(to.depth - from.depth);
        if (k != i && !pairs.contact(k).active && is_over(to, detection_rule::end_tolerance) &&
            dot(to.normal, from.normal) > cos_same_surface && depth_change < min_change) {
            min_change = depth_change;
            found = k;
        }
    }
    return found;
}

/// Removes a contact and its forces.
void clear(NodePairs& pairs, std::int32_t i) {
    pairs.contact(i) = NodeEdgeContact{};
    std::fill_n(pairs.forces(i), 3, Vector2{});
}

/// Ends a contact whose node slips off. The energy of its springs is lost and counted as friction.
void end_contact(NodePairs& pairs, std::int32_t i) {
    const FrictionLaw law = friction_law(pairs.data.assemblage, pairs.data.parameters.laws, pairs.pair(i));
    pairs.data.friction += node_edge_energy(law, pairs.contact(i));
    clear(pairs, i);
}

/// Transfers a contact to edge `to`, of the same grain or another. Overlap and elastic slip do not change, nor do the energy and
/// the magnitudes of the forces; the forces take the directions of the new edge.
void transfer_contact(NodePairs& pairs, std::int32_t from, std::int32_t to) {
    NodeEdgeContact contact = pairs.contact(from);
    contact.initial_overlap = pairs.depth(to) - contact.overlap;
    pairs.contact(to) = contact;
    clear(pairs, from);
}

/// Returns the edge on which contact `i` continues; −1 if it ends.
///
/// Near a convex corner the nearer face carries the contact. The contact has no force where its depth is the initial overlap, so
/// its overlap, not its depth, is compared with the depth behind a face without a contact. A node that is not behind the other
/// face is outside the grain, and its contact ends.
std::int32_t continue_contact(NodePairs& pairs, std::int32_t i) {
    std::int32_t to = i;
    const double overlap = pairs.depth(i) - pairs.contact(i).initial_overlap;
    if (const std::int32_t face = nearer_face(pairs, i, overlap); face >= 0) {
        to = pairs.depth(face) > 0 ? face : -1;
    } else if (!is_over(pairs.geometry(i), detection_rule::end_tolerance)) {
        to = next_edge(pairs, i);
    }
    if (to < 0) {
        end_contact(pairs, i);
    } else if (to != i) {
        transfer_contact(pairs, i, to);
    }
    return to;
}

void append_active(NodePairs& pairs, std::int32_t i) {
    append_active(pairs.data.assemblage, pairs.data.parameters.laws, pairs.data.chunk, pairs.index_in_list(i),
                  pairs.data.state.contact_pairs);
}

/// Decides how the contacts of a node continue, and lists those that do as active. The present contacts are collected first, as a
/// contact that is transferred to a later pair must not be treated twice.
void continue_contacts(NodePairs& pairs) {
    std::vector<std::int32_t>& active = pairs.data.scratch.active;
    active.clear();
    for (std::int32_t i = 0; i < pairs.size(); ++i) {
        if (const NodeEdgeContact& contact = pairs.contact(i); contact.active) {
            active.push_back(i);
        } else if (contact.release_correction != 0) {
            clear(pairs, i);
        }
    }
    for (const std::int32_t i : active) {
        if (const std::int32_t to = continue_contact(pairs, i); to >= 0) append_active(pairs, to);
    }
}

/// True if a contact may begin: the node is behind the edge, over it but for its corner zones, belongs to this edge and not to a
/// neighbouring face, and has no other contact with this grain or with the same surface. For a node deep inside the grain neither
/// the corner zones nor a contact with the same surface of another grain count.
bool may_begin(const NodePairs& pairs, std::int32_t i) {
    const PairGeometry g = pairs.geometry(i);
    if (pairs.contact(i).active || g.depth <= 0 || !is_over(g, 0)) return false;
    const bool is_deep = g.depth > detection_rule::deep_node_depth * pairs.data.assemblage.surface.mean_length;
    if (!is_deep && !is_over(g, -detection_rule::corner_zone)) return false;
    for (std::int32_t k = 0; k < pairs.size(); ++k) {
        if (pairs.contact(k).active && (pairs.edge(k).grain == pairs.edge(i).grain ||
                                        (!is_deep && dot(pairs.geometry(k).normal, g.normal) > cos_same_surface))) {
            return false;
        }
    }
    constexpr double margin = 0;
    return !belongs_to_neighbour(pairs.data.assemblage, pairs.data.state, pairs.pair(i), g, margin);
}

/// Begins contacts. `find_areas_of_new_contacts` gives them their areas when all chunks are done.
void begin_contacts(NodePairs& pairs) {
    for (std::int32_t i = 0; i < pairs.size(); ++i) {
        if (may_begin(pairs, i)) {
            const PairGeometry g = pairs.geometry(i);
            pairs.contact(i) = {.active = true, .near_first = g.place < 0.5, .area = area_not_found, .initial_overlap = g.depth};
            append_active(pairs, i);
            pairs.data.state.contact_pairs.active.changed[pairs.data.chunk] = 1;  // even if a contact of the same pair has ended
        }
    }
}

/// True if an edge belongs to a contact that has not been released and does not have the node.
bool is_between_others(const Assemblage& a, const State& s, std::int32_t node, const SurfaceEdge& edge) {
    if (edge.contact < 0 || s.contact_pairs.released[edge.contact] != 0) return false;
    const auto& nodes = a.contacts[edge.contact].nodes;
    return std::find(nodes.begin(), nodes.end(), node) == nodes.end();
}

/// Area available at a node, m²: half of its two outline edges (1 m thick), less the points of its contacts that have not been
/// released and the area of node–edge contacts; negative if these exceed it. \param occupied area of node–edge contacts, m²
double available_area(const Assemblage& a, const ContactPairList& list, std::int32_t node, double occupied) {
    const GrainSurface& surface = a.surface;
    double area = 2 * surface.tributary[node] - occupied;
    for (std::int32_t k = surface.edge_begin[node]; k < surface.edge_begin[node + 1]; ++k) {
        const std::int32_t contact = surface.edges[surface.edges_of_node[k]].contact;
        area -= contact >= 0 && list.released[contact] == 0 ? a.contacts[contact].point_area : 0.0;
    }
    return area;
}

/// The area of a node that new contacts request, and the fraction of it that each of them gets.
struct RequestedArea {
    double requested = 0, occupied = 0;  ///< m²
    double fraction = 1;
};

/// Calls `visit` with the pair of each active contact that has not ended and with the two nodes whose area it occupies: its own
/// node and the nearer end of its edge.
template <class Visit>
void for_occupied(const ContactPairList& list, Visit&& visit) {
    list.for_active([&](std::int32_t i) {
        const std::int32_t pair = list.active.pair[i];
        if (list.contacts[pair].active) {
            const auto& [node, first, second] = list.active.nodes[i];
            visit(pair, node, list.contacts[pair].near_first ? first : second);
        }
    });
}

}  // namespace

bool belongs_to_neighbour(const Assemblage& a, const State& s, const CandidatePair& pair, const PairGeometry& g, double margin) {
    const SurfaceEdge& edge = a.surface.edges[pair.edge];
    for (const std::int32_t neighbour : {edge.previous, edge.next}) {
        if (neighbour < 0) continue;
        const PairGeometry other = pair_geometry(a, s, CandidatePair{pair.node, neighbour});
        const double limit = is_between_others(a, s, pair.node, a.surface.edges[neighbour])
                                 ? std::min(g.depth, bond_width * a.surface.mean_length)
                                 : g.depth;
        if (is_convex_corner(g.tangent, other.tangent, neighbour == edge.next) && other.depth < limit - margin) return true;
    }
    return false;
}

/// Each new contact requests the tributary area of its node. All that request area of one node get the same fraction of it.
void find_areas_of_new_contacts(const Assemblage& a, const StepParameters& parameters, State& s) {
    ContactPairList& list = s.contact_pairs;
    std::vector<NewContact> contacts;
    std::unordered_map<std::int32_t, RequestedArea> requested;
    for_occupied(list, [&](std::int32_t pair, std::int32_t node, std::int32_t end) {
        if (list.contacts[pair].area != area_not_found) return;
        contacts.push_back({pair, {node, end}, a.surface.tributary[node]});
        for (const std::int32_t occupied : contacts.back().occupied) requested[occupied].requested += contacts.back().area;
    });
    if (contacts.empty() && !s.ghosts) return;
    for_occupied(list, [&](std::int32_t pair, std::int32_t node, std::int32_t end) {
        for (const std::int32_t occupied : {node, end}) {
            const auto found = requested.find(occupied);
            if (found != requested.end()) found->second.occupied += list.contacts[pair].area;
        }
    });
    for (auto& [node, area] : requested) area.fraction = available_area(a, list, node, area.occupied) / area.requested;
    if (s.ghosts) {  // the owner of a node knows all contacts that request area of it
        s.ghosts->update(
            [&](std::int32_t node) {
                const auto found = requested.find(node);
                return found != requested.end() ? found->second.fraction : 1;
            },
            [&](std::int32_t node, double fraction) {
                if (const auto found = requested.find(node); found != requested.end()) found->second.fraction = fraction;
            });
    }
    for (NewContact& contact : contacts) {
        double fraction = 1;
        for (const std::int32_t node : contact.occupied) fraction = std::min(fraction, requested[node].fraction);
        contact.area *= std::max(fraction, min_area);
    }
    limit_new_areas(a, parameters, contacts, s);
    for (const NewContact& contact : contacts) list.contacts[contact.pair].area = contact.area;
}

void detect_contacts(const Assemblage& a, const StepParameters& parameters, std::int32_t chunk, State& s) {
    ContactPairList& list = s.contact_pairs;
    const Range groups = list.chunks[chunk];
    const std::int32_t begin = list.first_watched(chunk);
    const std::int32_t end = list.watched_groups[groups.end - 1].end;
    static thread_local Scratch scratch;
    ChunkData data{a, parameters, s, scratch, chunk};
    scratch.geometry.clear();
    for (std::int32_t i = begin; i < end; ++i) scratch.geometry.push_back(pair_geometry(a, s, list.pairs[list.watched[i]]));
    const auto for_nodes = [&](auto&& act) {
        for (std::int32_t i = groups.begin; i < groups.end; ++i) {
            NodePairs pairs{data, list.watched_groups[i], begin};
            act(pairs);
        }
    };
    const std::int32_t count_before = list.active.count[chunk];
    list.active.count[chunk] = 0;
    list.active.changed[chunk] = 0;
    for_nodes(continue_contacts);
    move_active_contacts(a, parameters, chunk, s);
    for_nodes(begin_contacts);  // after the move: a new contact begins without a force at the present displacements
    list.active.changed[chunk] = list.active.changed[chunk] != 0 || list.active.count[chunk] != count_before ? 1 : 0;
    list.friction[list.node_chunks[chunk]] += data.friction;
}

}  // namespace graincrack
