#include "solver/step/contact_energy.hpp"

#include "solver/detection/active_contacts.hpp"

namespace graincrack {

double stored_in_chunk(const Assemblage& a, const ContactLaws& laws, std::int32_t index, const State& s) {
    const ContactChunk& chunk = a.contact_chunks[index];
    const ContactLaw& law = laws[chunk.contact_class];
    return contact_law::with_law(laws.variant(), [&](auto kind) {
        return sum_over(chunk.contacts, [&](std::int32_t c) {
            const auto [first, second] = points_of(c);
            const double of_points = decltype(kind)::stored_energy(law, point_history(s, first)) +
                                     decltype(kind)::stored_energy(law, point_history(s, second));  // per area, over s²
            const double strength = a.contacts[c].strength;
            return s.contact_pairs.released[c] != 0 ? 0 : strength * strength * a.contacts[c].point_area * of_points;
        });
    });
}

double stored_in_contacts(const Assemblage& a, const ContactLaws& laws, const State& s) {
    const std::vector<double> active = energy_of_active_contacts(a, laws, s.contact_pairs);
    return sum_over_chunks(a.part, a.part.nodes, [&](std::int32_t chunk) { return active[chunk]; }) +
           sum_over_chunks(a.part, a.part.contacts, [&](std::int32_t chunk) { return stored_in_chunk(a, laws, chunk, s); });
}

}  // namespace graincrack
