#include "solver/model/state.hpp"

namespace graincrack {

namespace {

/// Length of an array of a new state; 0 for those that are found later.
std::size_t length_of(ArrayOf of, const Assemblage& a) {
    switch (of) {
        case ArrayOf::nodes: return a.position.size();
        case ArrayOf::points: return 2 * a.contacts.size();
        case ArrayOf::contact_slots: return a.n_slot_values();
        case ArrayOf::element_slots: return a.n_element_slot_values();
        case ArrayOf::node_chunks: return a.node_chunks.size();
        case ArrayOf::contact_chunks: return a.contact_chunks.size();
        default: return 0;
    }
}

}  // namespace

State make_state(const Assemblage& a, const Boundary& boundary, const Specimen& specimen) {
    State s;
    visit_arrays(s, [&](const char* /*name*/, ArrayOf of, auto& values) { values.resize(length_of(of, a)); });
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
    s.events.resize(a.contact_chunks.size());
    for (std::vector<ContactEvent>& of_chunk : s.events) of_chunk.reserve(max_events_per_chunk);
    return s;
}

}  // namespace graincrack
