#include "solver/run/frame.hpp"

namespace graincrack {
namespace {

/// Motions, tractions, damage and states of all contact points, into a frame.
template <class Law>
void add_contacts(const Assemblage& a, const ContactLaws& laws, const State& s, Frame& frame) {
    for (auto* pairs : {&frame.opening, &frame.sliding, &frame.damage}) pairs->resize(a.n_contacts());
    frame.traction.resize(a.n_contacts());
    frame.state.resize(a.n_contacts());
    for_each_contact(a, [&](std::int32_t place, std::int32_t contact_class) {
        const ContactLaw& law = laws[contact_class];
        const std::int32_t c = a.specimen_contact[place];
        const double strength = a.contacts[place].strength;
        const bool released = s.contact_pairs.released[place] != 0;  // node–edge contacts carry its load
        for (std::size_t end = 0; end < 2; ++end) {
            const ContactHistory h = point_history(s, points_of(place)[end]);
            const ContactTraction t = released ? ContactTraction{} : contact_law::update<Law>(law, h.motion, h).traction;
            frame.opening[c][end] = strength * h.motion.opening;
            frame.sliding[c][end] = strength * h.motion.sliding;
            frame.traction[c][2 * end] = strength * t.normal;
            frame.traction[c][2 * end + 1] = strength * t.shear;
            frame.damage[c][end] = contact_law::damage<Law>(law, h);
            frame.state[c][end] = static_cast<std::uint8_t>(point_state(h));
        }
    });
}

}  // namespace

Frame make_frame(const Assemblage& a, const ContactLaws& laws, const State& s) {
    Frame frame;
    frame.time = s.time;
    frame.step = s.step;
    for (const std::int32_t i : a.node_of_specimen) {
        frame.displacement.push_back({s.displacement[i].x, s.displacement[i].y});
        frame.velocity.push_back({s.velocity[i].x, s.velocity[i].y});
    }
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        frame.element_stress.push_back(triangle_stress(a.elasticity[e], element_state(a, e, s)));
    }
    contact_law::with_law(laws.variant(), [&](auto kind) { add_contacts<decltype(kind)>(a, laws, s, frame); });
    return frame;
}

}  // namespace graincrack
