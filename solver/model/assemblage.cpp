#include "solver/model/assemblage.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace graincrack {
namespace {

void add_elements(Assemblage& a, const Specimen& s, const std::vector<Phase>& phases, PlaneCondition plane) {
    a.mass.assign(s.n_nodes(), 0.0);
    a.phase_of_node.assign(s.n_nodes(), 0);
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        const std::uint8_t phase_index = s.grain_phase[s.element_grain[e]];
        const Phase& phase = phases.at(phase_index);
        const auto& nodes = s.element_nodes[e];
        const std::array<std::int32_t, 3> n{a.node_of_specimen[nodes[0]], a.node_of_specimen[nodes[1]],
                                            a.node_of_specimen[nodes[2]]};
        a.element_nodes.push_back(n);
        const TriangleGeometry g = make_triangle_geometry(a.position[n[0]], a.position[n[1]], a.position[n[2]]);
        a.element_geometry.push_back(g);
        a.elasticity.push_back(make_plane_elasticity(phase.young_modulus, phase.poisson_ratio, plane));
        a.element_mass.push_back(phase.density * g.area);
        for (const std::int32_t node : n) {
            a.mass[node] += a.element_mass.back() / 3;
            a.phase_of_node[node] = phase_index;
        }
    }
    a.rock_mass = a.mass;
    a.inverse_mass.resize(a.mass.size());
    std::transform(a.mass.begin(), a.mass.end(), a.inverse_mass.begin(), [](double m) { return m > 0 ? 1 / m : 0.0; });
}

Expansion make_expansion(const Specimen& s, const std::vector<Phase>& phases, PlaneCondition plane) {
    if (!Fabric{phases, {}}.feels_temperature()) return {};
    Expansion x{phases, plane, {}, {}};
    const std::vector<double> angles = crystal_axes(s);
    for (const std::int32_t grain : s.element_grain) {
        x.phase.push_back(s.grain_phase[grain]);
        x.axis.push_back(make_crystal_axis(angles[grain]));
    }
    return x;
}

ContactGeometry geometry_of(const Assemblage& a, const Specimen& s, std::int32_t contact) {
    ContactGeometry g{};
    for (std::size_t k = 0; k < 4; ++k) g.nodes[k] = a.node_of_specimen[s.contact_nodes[contact][k]];
    g.edge = a.position[g.nodes[1]] - a.position[g.nodes[0]];
    g.point_area = 0.5 * length(g.edge);
    g.strength = s.contact_strength_factor.empty() ? 1 : s.contact_strength_factor[contact];
    return g;
}

/// Gives every contact its place: class by class, each class beginning a new chunk.
void place_contacts(Assemblage& a, const Specimen& s) {
    const std::vector<std::uint8_t> classes = contact_classes(s);
    std::vector<std::vector<std::int32_t>> of_class(contact_class_names(s).size());
    for (std::size_t c = 0; c < classes.size(); ++c) of_class[classes[c]].push_back(static_cast<std::int32_t>(c));
    a.contact_of_specimen.resize(s.n_contacts());
    for (std::size_t k = 0; k < of_class.size(); ++k) {
        const auto n = static_cast<std::int32_t>(of_class[k].size());
        for (std::int32_t i = 0; i < n; ++i) {
            if (i % contacts_per_chunk == 0) {
                const auto place = static_cast<std::int32_t>(a.contact_chunks.size()) * contacts_per_chunk;
                a.contact_chunks.push_back({{place, place + std::min(contacts_per_chunk, n - i)}, static_cast<std::int32_t>(k)});
            }
            const std::int32_t place = a.contact_chunks.back().contacts.begin + i % contacts_per_chunk;
            a.contact_of_specimen[of_class[k][i]] = place;
        }
    }
    a.specimen_contact.assign(a.contact_chunks.empty() ? 0 : a.contact_chunks.back().contacts.end, -1);
    for (std::int32_t c = 0; c < a.n_contacts(); ++c) a.specimen_contact[a.contact_of_specimen[c]] = c;
}

void add_contacts(Assemblage& a, const Specimen& s) {
    place_contacts(a, s);
    a.contacts.resize(a.specimen_contact.size());
    for (std::int32_t c = 0; c < a.n_contacts(); ++c) {
        const ContactGeometry g = geometry_of(a, s, c);
        a.contact_length += length(g.edge);
        a.contacts[a.contact_of_specimen[c]] = g;
    }
}

/// Gives a node a slot.
template <std::size_t few>
void add_slot(std::int32_t node, std::int32_t slot, std::int32_t none, SlotsOfNodes<few>& slots) {
    auto& first = slots.first[node];
    if (const auto free = std::find(first.begin(), first.end(), none); free != first.end()) {
        *free = slot;
    } else {
        slots.further.push_back({node, slot});
    }
}
template <std::size_t few>
void sort_further_slots(const Assemblage& a, SlotsOfNodes<few>& slots) {
    std::stable_sort(slots.further.begin(), slots.further.end(),
                     [](const FurtherSlot& l, const FurtherSlot& r) { return l.node < r.node; });
    slots.further_of_chunk = ranges_by_chunk(a, slots.further, [](const FurtherSlot& slot) { return slot.node; });
}

void add_contact_slots(Assemblage& a) {
    const auto none = static_cast<std::int32_t>(a.contact_chunks.size()) * slot_stride;
    a.contact_slots.first.assign(a.position.size(), {none, none});  // every node of an outline has an edge on either side
    for_each_contact(a, [&](std::int32_t c, std::int32_t /*contact_class*/) {
        for (std::int32_t k = 0; k < 4; ++k) add_slot(a.contacts[c].nodes[k], slot_of(c, k), none, a.contact_slots);
    });
    sort_further_slots(a, a.contact_slots);
}

void add_element_slots(Assemblage& a) {
    for (std::int32_t e = 0; e < a.n_elements(); e += elements_per_chunk) {
        a.element_chunks.push_back({e, std::min(e + elements_per_chunk, a.n_elements())});
    }
    const auto none = static_cast<std::int32_t>(a.element_chunks.size()) * element_slot_stride;
    a.element_slots.first.assign(a.position.size(), {none});
    for (std::int32_t e = 0; e < a.n_elements(); ++e) {
        for (std::int32_t k = 0; k < 3; ++k) add_slot(a.element_nodes[e][k], element_slot_of(e, k), none, a.element_slots);
    }
    sort_further_slots(a, a.element_slots);
}

}  // namespace

Assemblage make_assemblage(const Specimen& specimen, const std::vector<Phase>& phases, PlaneCondition plane) {
    Assemblage a;
    NodeOrder order = order_nodes(specimen);
    a.node_of_specimen = std::move(order.node_of_specimen);
    a.node_chunks = std::move(order.chunks);
    a.rows = std::move(order.rows);
    a.cluster_of_node = std::move(order.cluster_of_node);
    a.position.resize(specimen.n_nodes());
    for (std::size_t i = 0; i < specimen.n_nodes(); ++i) {
        a.position[a.node_of_specimen[i]] = {specimen.node_position[i][0], specimen.node_position[i][1]};
    }
    add_elements(a, specimen, phases, plane);
    a.expansion = make_expansion(specimen, phases, plane);
    a.n_phase_classes = static_cast<std::int32_t>(n_contact_classes(phases.size()));
    add_contacts(a, specimen);
    add_contact_slots(a);
    add_element_slots(a);
    a.surface = make_surface(specimen, a.node_of_specimen, a.contact_of_specimen);
    a.part = whole_part(a);
    return a;
}

Assemblage make_assemblage(const Specimen& specimen, const Rock& rock, PlaneCondition plane) {
    return make_assemblage(specimen, std::vector<Phase>(specimen.phase_names.size(), phase_of(rock)), plane);
}

double expansion_difference(const Assemblage& a) {
    if (a.expansion.empty()) return 0;
    double difference = 0;
    for (const double temperature : {0.0, quantity::temperature.upper}) {  // rates of curves may grow on the way
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        for (const Phase& phase : a.expansion.phases) {
            const PlaneWarmth warmth = plane_warmth(phase, a.expansion.plane, temperature);
            for (const double rate : {warmth.across_rate, warmth.across_rate + warmth.more_along_rate}) {
                least = std::min(least, rate);
                most = std::max(most, rate);
            }
        }
        difference = std::max({difference, most - least, std::max(std::abs(least), std::abs(most)) / 3});
    }
    return difference;
}

}  // namespace graincrack
