// The contact pair list: which nodes may come into contact with which edges, kept between searches, and the state of each pair.
//
// Nothing is searched between grains that are still bonded. A contact point has debonded when it has lost its cohesion, or failed
// and moved; an edge is exposed when it is a free face, or a point of its contact or of the one before or after it on the grain
// has debonded: another grain may have come in at the corner. A node is exposed when an edge of it is. A contact without cohesion
// continues as a contact with its original partner (compression and friction) until it has moved by `release_travel` of its
// length; then it is released: its tractions pass to node–edge contacts, and from then on contacts of its nodes and edges are
// detected like all others.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "solver/model/assemblage.hpp"

namespace graincrack {

/// Constants of a node–edge contact.
struct FrictionLaw {
    double normal_stiffness, shear_stiffness;  ///< Pa/m
    double cohesion;                           ///< c_r, Pa
    double tan_friction;                       ///< of φ_r
    double tan_fresh = 0;                      ///< tan φc − tan φ_r, which faces that wear have beside it at first
    double inv_wear_slip = 0;                  ///< 1/w, 1/m
};

/// The state of a node–edge contact.
struct NodeEdgeContact {
    bool active = false;            ///< false from the step on in which it ends
    bool near_first = true;         ///< nearer to the first end of the edge than to the second
    double area = 0;                ///< A of the node, m²
    double initial_overlap = 0;     ///< m
    double overlap = 0;             ///< e at the last update, m
    double elastic_slip = 0;        ///< q, m
    double release_correction = 0;  ///< tension in the step after its end, as a depth, ½ e o/(e + o), m
    /// Whether it is active, or has ended and is corrected in the next step.
    [[nodiscard]] bool is_at_work() const { return active || release_correction != 0; }
};

/// A node and an edge of another grain that are near each other.
struct CandidatePair {
    std::int32_t node;
    std::int32_t edge;  ///< of the surface
    // NOLINTNEXTLINE(modernize-use-nullptr): it is none
    friend auto operator<=>(const CandidatePair&, const CandidatePair&) = default;
};

/// Forces on a node that come from active contacts.
struct NodeForces {
    std::int32_t node;
    Range slots;  ///< into `ContactPairList::node_force_slots`
};

/// The active contacts: most steps work on nothing else. Detection decides at intervals which of them continue.
struct ActiveContacts {
    std::vector<std::int32_t> pair;                  ///< in the list
    std::vector<std::array<std::int32_t, 3>> nodes;  ///< the node, first and second of the edge
    std::vector<FrictionLaw> laws;
    std::vector<std::int32_t> count;    ///< by chunk; those of a chunk lie from its first watched pair on
    std::vector<std::uint8_t> changed;  ///< by chunk: 1 if the last detection found others than before, or one that began anew
};

struct ContactPairList {
    std::vector<std::uint8_t> debonded;     ///< [2 c] 1 once the point no longer links its nodes
    std::vector<std::uint8_t> released;     ///< [c] 1 once the contact has been released to node–edge contacts
    std::vector<CandidatePair> pairs;       ///< ascending
    std::vector<NodeEdgeContact> contacts;  ///< [pairs]
    std::vector<Vector2> forces;            ///< [3 pairs] on node, first and second node of the edge, N
    std::vector<Range> groups;              ///< pairs of one node
    std::vector<std::int32_t> watched;      ///< pairs that may be in contact before the next update, ascending
    std::vector<Range> watched_groups;      ///< of them, of one node each
    std::vector<Range> chunks;              ///< of `watched_groups`: those of a chunk of nodes, that a thread works on at a time
    std::vector<std::int32_t> node_chunks;  ///< [chunks] the chunk of nodes
    std::int64_t detection_interval = 1;    ///< steps from one detection to the next
    ActiveContacts active;
    std::vector<double> friction;                  ///< [chunks of nodes] dissipated since the start, J
    std::vector<NodeForces> node_forces;           ///< ascending by node
    std::vector<std::int32_t> node_force_slots;    ///< into `forces`
    std::vector<Range> node_forces_of_chunk;       ///< by chunk of nodes
    std::vector<std::int32_t> node_force_scratch;  ///< [n]
    std::vector<Vector2> displacement_at_search;   ///< [n] m
    bool wants_rebuild = false;                    ///< a point has debonded or a contact is to be released since the last search
    double travel_since_rebuild = 0;               ///< that nodes at the 95th percentile of speed may have moved since then, m
    /// [clusters] L_C (stable_area.hpp) when a contact began, or at the last update, N/m; empty without mass scaling
    std::vector<double> cluster_load;
    bool is_watched_anywhere = true;  ///< whether a rank watches pairs
    std::int64_t next_update = 0;     ///< step before which the list is updated again

    [[nodiscard]] std::int32_t first_watched(std::int32_t chunk) const { return watched_groups[chunks[chunk].begin].begin; }
    /// Calls `visit` with the index of each active contact of a chunk in `active`.
    template <class Visit>
    void for_active_of(std::int32_t chunk, const Visit& visit) const {
        const std::int32_t begin = first_watched(chunk);
        for (std::int32_t i = begin; i < begin + active.count[chunk]; ++i) visit(i);
    }
    /// The same of all chunks.
    template <class Visit>
    void for_active(const Visit& visit) const {
        for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(chunks.size()); ++chunk) {
            for_active_of(chunk, visit);
        }
    }
};

/// Finds the groups of the pairs.
void group_pairs(ContactPairList& list);
/// Finds the groups of the watched pairs, and their chunks.
void group_watched(const Assemblage& assemblage, ContactPairList& list);

/// An empty list; pre-existing cracks are found by the first search.
ContactPairList make_contact_pair_list(const Assemblage& assemblage);

}  // namespace graincrack
