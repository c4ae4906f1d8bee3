// The contact pair list has the pairs of nodes and edges that may come into contact before the next search, and their states.
//
// Grains that are still bonded are not searched. A contact point has debonded when it has lost its cohesion, or has failed and
// moved. An edge is exposed if it is a free face, or if a point of its contact or of the contact before or after it on the grain
// has debonded, so that another grain may enter at the corner. A node is exposed if one of its edges is. A contact without
// cohesion carries compression and friction between its original partners until it has moved by `release_travel` of its length.
// It is then released: its tractions pass to node–edge contacts, and contacts of its nodes and edges are detected like others.
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
    double tan_fresh = 0;                      ///< tan φc − tan φ_r, which wear removes
    double inv_wear_slip = 0;                  ///< 1/w, 1/m
};

/// The state of a node–edge contact.
struct NodeEdgeContact {
    bool active = false;            ///< false from the step in which it ends
    bool near_first = true;         ///< nearer to the first end of the edge than to the second
    double area = 0;                ///< A of the node, m²
    double initial_overlap = 0;     ///< m
    double overlap = 0;             ///< e at the last update, m
    double elastic_slip = 0;        ///< q, m
    double release_correction = 0;  ///< tension in the step after its end, as a depth, ½ e o/(e + o), m
    /// True if it is active, or has ended and is corrected in the next step.
    [[nodiscard]] bool is_at_work() const { return active || release_correction != 0; }
};

/// A node and a near edge of another grain.
struct CandidatePair {
    std::int32_t node;
    std::int32_t edge;  ///< of the surface
    // NOLINTNEXTLINE(modernize-use-nullptr): there is no pointer
    friend auto operator<=>(const CandidatePair&, const CandidatePair&) = default;
};

/// The forces of active contacts on a node.
struct NodeForces {
    std::int32_t node;
    Range slots;  ///< into `ContactPairList::node_force_slots`
};

/// The active contacts, which are all that most steps evaluate. Detection decides at intervals which of them continue.
struct ActiveContacts {
    std::vector<std::int32_t> pair;                  ///< index in the list
    std::vector<std::array<std::int32_t, 3>> nodes;  ///< the node, first and second of the edge
    std::vector<FrictionLaw> laws;
    std::vector<std::int32_t> count;    ///< by chunk; the contacts of a chunk start at its first watched pair
    std::vector<std::uint8_t> changed;  ///< by chunk: 1 if the last detection changed the active contacts or began one
};

struct ContactPairList {
    std::vector<std::uint8_t> debonded;     ///< [2 c] 1 once the point no longer links its nodes
    std::vector<std::uint8_t> released;     ///< [c] 1 once the contact has been released to node–edge contacts
    std::vector<CandidatePair> pairs;       ///< ascending
    std::vector<NodeEdgeContact> contacts;  ///< [pairs]
    std::vector<Vector2> forces;            ///< [3 pairs] on node, first and second node of the edge, N
    std::vector<Range> groups;              ///< pairs of one node
    std::vector<std::int32_t> watched;      ///< pairs that may be in contact before the next update, ascending
    std::vector<Range> watched_groups;      ///< watched pairs of one node
    std::vector<Range> chunks;              ///< groups of `watched_groups` of a chunk of nodes, on which one thread works
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
    double travel_since_rebuild = 0;               ///< travel since then at the 95th percentile of speed, m
    /// [clusters] L_C (stable_area.hpp) when a contact began, or at the last update, N/m; empty without mass scaling
    std::vector<double> cluster_load;
    bool is_watched_anywhere = true;  ///< true if any rank watches pairs
    std::int64_t next_update = 0;     ///< step before which the list is updated again

    [[nodiscard]] std::int32_t first_watched(std::int32_t chunk) const { return watched_groups[chunks[chunk].begin].begin; }
    /// Calls `visit` with the index of each active contact of a chunk in `active`.
    template <class Visit>
    void for_active_of(std::int32_t chunk, const Visit& visit) const {
        const std::int32_t begin = first_watched(chunk);
        for (std::int32_t i = begin; i < begin + active.count[chunk]; ++i) visit(i);
    }
    /// Calls `visit` with the index of each active contact of all chunks.
    template <class Visit>
    void for_active(const Visit& visit) const {
        for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(chunks.size()); ++chunk) {
            for_active_of(chunk, visit);
        }
    }
};

/// Sets the groups of the pairs.
void group_pairs(ContactPairList& list);
/// Sets the groups of the watched pairs, and their chunks.
void group_watched(const Assemblage& assemblage, ContactPairList& list);

/// Returns an empty list. The first search finds pre-existing cracks.
ContactPairList make_contact_pair_list(const Assemblage& assemblage);

}  // namespace graincrack
