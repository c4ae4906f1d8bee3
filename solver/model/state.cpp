#include "solver/model/state.hpp"

namespace graincrack {

State make_state(const Assemblage& a, const Boundary& boundary, const Specimen& specimen) {
    State s;
    for (auto* of_nodes :
         {&s.displacement, &s.velocity, &s.force, &s.last_force, &s.damping_force, &s.damping_load.mean_displacement}) {
        of_nodes->resize(a.position.size());
    }
    s.near_platen.resize(a.position.size());
    s.contact_force.resize(a.n_slot_values());
    s.element_force.resize(a.n_element_slot_values());
    s.points = PointHistories(2 * a.contacts.size());
    for (auto* of_points : {&s.opening, &s.sliding, &s.slip, &s.fracture_energy}) of_points->resize(2 * a.contacts.size());
    for (auto* of_points : {&s.failed, &s.residual}) of_points->resize(2 * a.contacts.size());
    s.next_level.assign(2 * a.contacts.size(), damage_level(0));
    s.integrity.assign(2 * a.contacts.size(), 1);
    for_each_contact(a, [&](std::int32_t place, std::int32_t /*contact_class*/) {
        const std::uint8_t kind = specimen.contact_kind[a.specimen_contact[place]];
        for (const std::size_t point : points_of(place)) {
            if (starts_broken(kind)) {
                store_point(broken_contact(), false, point, s);  // residual from the first step on, when the law has seen it
                s.next_level[point] = 0;
            }
        }
    });
    s.contact_pairs = make_contact_pair_list(a);
    s.platen_points = boundary.platen_points;
    s.loading.platen_axis = boundary.platens.front().axis;
    s.prescribed.nodes.resize(boundary.prescribed.nodes.size());
    s.prescribed.load.resize(boundary.prescribed.edges.size());
    s.prescribed.lateral.resize(boundary.prescribed.edges.size());
    s.node_sums.resize(a.node_chunks.size());
    s.contact_sums.resize(a.contact_chunks.size());
    s.events.resize(a.contact_chunks.size());
    for (std::vector<ContactEvent>& of_chunk : s.events) of_chunk.reserve(max_events_per_chunk);
    return s;
}

}  // namespace graincrack
