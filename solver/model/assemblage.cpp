#include "solver/model/assemblage.hpp"

#include <algorithm>
#include <numeric>

#include "solver/model/memory.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t chunk_elements = 64;  // a chunk's nodes, elements and forces stay within a first-level cache

/// Nodes sorted by grain; nodes of no element come last.
std::vector<std::int32_t> order_nodes(const Specimen& s) {
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    std::vector<std::int32_t> order(s.n_nodes());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&grain](std::int32_t i, std::int32_t j) {
        return static_cast<std::uint32_t>(grain[i]) < static_cast<std::uint32_t>(grain[j]);
    });
    return order;
}

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

ContactGeometry geometry_of(const Assemblage& a, const Specimen& s, std::int32_t contact) {
    ContactGeometry g{};
    for (std::size_t k = 0; k < 4; ++k) {
        g.nodes[k] = a.node_of_specimen[s.contact_nodes[contact][k]];
    }
    g.edge = a.position[g.nodes[1]] - a.position[g.nodes[0]];
    g.point_area = 0.5 * length(g.edge);
    g.strength = s.contact_strength_factor.empty() ? 1 : s.contact_strength_factor[contact];
    return g;
}

/// Gives every contact its place: class by class, each class beginning a new chunk.
void place_contacts(Assemblage& a, const Specimen& s, std::size_t n_phases) {
    std::vector<std::vector<std::int32_t>> of_class(n_contact_classes(n_phases));
    for (std::int32_t c = 0; c < static_cast<std::int32_t>(s.n_contacts()); ++c) {
        const auto& nodes = s.contact_nodes[c];
        of_class[class_between(a, a.node_of_specimen[nodes[0]], a.node_of_specimen[nodes[2]])].push_back(c);
    }
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
    for (std::int32_t c = 0; c < a.n_contacts(); ++c) {
        a.specimen_contact[a.contact_of_specimen[c]] = c;
    }
}

void add_contacts(Assemblage& a, const Specimen& s, std::size_t n_phases) {
    place_contacts(a, s, n_phases);
    a.contacts.resize(a.specimen_contact.size());
    for (std::int32_t c = 0; c < a.n_contacts(); ++c) {
        const ContactGeometry g = geometry_of(a, s, c);
        a.contact_length += length(g.edge);
        a.contacts[a.contact_of_specimen[c]] = g;
    }
    // Every node of an outline has an edge on either side.
    const auto none = static_cast<std::int32_t>(a.contact_chunks.size()) * slot_stride;
    a.slots.assign(a.position.size(), {none, none});
    for_each_contact(a, [&](std::int32_t c, std::int32_t /*contact_class*/) {
        for (std::int32_t k = 0; k < 4; ++k) {
            const std::int32_t node = a.contacts[c].nodes[k];
            const auto free = std::find(a.slots[node].begin(), a.slots[node].end(), none);
            if (free != a.slots[node].end()) {
                *free = slot_of(c, k);
            } else {
                a.further_slots.push_back({node, slot_of(c, k)});
            }
        }
    });
    std::stable_sort(a.further_slots.begin(), a.further_slots.end(),
                     [](const FurtherSlot& l, const FurtherSlot& r) { return l.node < r.node; });
}

/// The first further slot of a node not below `node`.
std::int32_t first_further_slot(const Assemblage& a, std::int32_t node) {
    const auto it = std::lower_bound(a.further_slots.begin(), a.further_slots.end(), node,
                                     [](const FurtherSlot& slot, std::int32_t at) { return slot.node < at; });
    return static_cast<std::int32_t>(it - a.further_slots.begin());
}

/// Cuts grains into chunks of about `chunk_elements` elements; nodes follow their grains.
void cut_chunks(Assemblage& a, const Specimen& s) {
    std::int32_t begin = 0;
    std::int32_t node_begin = 0;
    std::int32_t further_begin = 0;
    const std::int32_t n = a.n_elements();
    for (std::int32_t e = 1; e <= n; ++e) {
        const bool grain_ends = e == n || s.element_grain[e] != s.element_grain[e - 1];
        if (!grain_ends || (e < n && e - begin < chunk_elements)) {
            continue;
        }
        std::int32_t node_end = node_begin;
        for (std::int32_t i = begin; i < e; ++i) {
            node_end = std::max({node_end, a.element_nodes[i][0] + 1, a.element_nodes[i][1] + 1, a.element_nodes[i][2] + 1});
        }
        const Range further{further_begin, first_further_slot(a, node_end)};
        a.grain_chunks.push_back({{begin, e}, {node_begin, node_end}, further});
        begin = e;
        node_begin = node_end;
        further_begin = further.end;
    }
}

}  // namespace

Assemblage make_assemblage(const Specimen& specimen, const std::vector<Phase>& phases, PlaneCondition plane) {
    Assemblage a;
    const std::vector<std::int32_t> order = order_nodes(specimen);
    a.node_of_specimen.resize(order.size());
    a.position.resize(order.size());
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(order.size()); ++i) {
        a.node_of_specimen[order[i]] = i;
        a.position[i] = {specimen.node_position[order[i]][0], specimen.node_position[order[i]][1]};
    }
    add_elements(a, specimen, phases, plane);
    add_contacts(a, specimen, phases.size());
    cut_chunks(a, specimen);
    a.surface = make_surface(specimen, a.node_of_specimen, a.contact_of_specimen);
    return a;
}

Assemblage make_assemblage(const Specimen& specimen, const Rock& rock, PlaneCondition plane) {
    return make_assemblage(specimen, std::vector<Phase>(specimen.phase_names.size(), phase_of(rock)), plane);
}

std::size_t memory_of(const ElasticityTable& table) {
    const auto& [c11, c12, mu, czz] = table;
    return memory_of_all(c11, c12, mu, czz);
}

std::size_t memory_of(const TriangleTable& table) {
    const auto& [gradient1_x, gradient1_y, gradient2_x, gradient2_y, area] = table;
    return memory_of_all(gradient1_x, gradient1_y, gradient2_x, gradient2_y, area);
}

std::size_t memory_of(const Assemblage& assemblage) {
    const auto& [position, mass, inverse_mass, rock_mass, element_nodes, element_geometry, elasticity, element_mass, contacts,
                 slots, further_slots, grain_chunks, contact_chunks, node_of_specimen, contact_of_specimen, specimen_contact,
                 phase_of_node, surface, contact_length, vector_target] = assemblage;
    return memory_of_all(position, mass, inverse_mass, rock_mass, element_nodes, element_geometry, elasticity, element_mass,
                         contacts, slots, further_slots, grain_chunks, contact_chunks, node_of_specimen, contact_of_specimen,
                         specimen_contact, phase_of_node, surface);
}

}  // namespace graincrack
