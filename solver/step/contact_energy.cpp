#include "solver/step/contact_energy.hpp"

#include "solver/detection/active_contacts.hpp"

namespace graincrack {

double stored_in_contacts(const Assemblage& a, const ContactLaws& laws, const State& s) {
    double energy = stored_in_active_contacts(a, laws, s.contact_pairs);
    contact_law::with_law(laws.variant(), [&](auto kind) {
        energy += sum_over_chunks(a.part, a.part.contacts, [&](std::int32_t index) {
            const ContactChunk& chunk = a.contact_chunks[index];
            const ContactLaw& law = laws[chunk.contact_class];
            return sum_over(chunk.contacts, [&](std::int32_t c) {
                const auto [first, second] = points_of(c);
                const double of_points = decltype(kind)::stored_energy(law, point_history(s, first)) +
                                         decltype(kind)::stored_energy(law, point_history(s, second));  // per area, over s²
                const double strength = a.contacts[c].strength;
                return s.contact_pairs.released[c] != 0 ? 0 : strength * strength * a.contacts[c].point_area * of_points;
            });
        });
    });
    return energy;
}

}  // namespace graincrack
