#include "solver/model/contact_pairs.hpp"

#include "solver/model/memory.hpp"

namespace graincrack {

ContactPairList make_contact_pair_list(const Assemblage& a) {
    ContactPairList list;
    list.debonded.assign(2 * a.contacts.size(), 0);
    list.released.assign(a.contacts.size(), 0);
    list.node_forces_of_chunk.assign(a.node_chunks.size(), Range{});
    return list;
}

std::size_t memory_of(const ActiveContacts& active) {
    const auto& [pair, nodes, live, area, initial_overlap, overlap, elastic_slip, release_correction, normal_stiffness,
                 shear_stiffness, cohesion, tan_friction, place, forces, count, changed] = active;
    return memory_of_all(pair, nodes, live, area, initial_overlap, overlap, elastic_slip, release_correction, normal_stiffness,
                         shear_stiffness, cohesion, tan_friction, place, forces, count, changed);
}

std::size_t memory_of(const ContactPairList& list) {
    const auto& [debonded, released, pairs, contacts, forces, groups, watched, watched_groups, chunks, detection_interval, active,
                 friction, friction_before, node_forces, node_force_slots, node_forces_of_chunk, node_force_scratch,
                 displacement_at_search, wants_rebuild, travel_since_rebuild, occupied_area, cluster_load, next_update] = list;
    return memory_of_all(debonded, released, pairs, contacts, forces, groups, watched, watched_groups, chunks, active, friction,
                         node_forces, node_force_slots, node_forces_of_chunk, node_force_scratch, displacement_at_search,
                         occupied_area, cluster_load);
}

}  // namespace graincrack
