#include "solver/detection/active_contacts.hpp"

#include <algorithm>
#include <cstddef>

#include "solver/arithmetic/simd.hpp"
#include "solver/detection/node_edge_contact.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t max_contacts = 64;  // that a vector kernel works on at a time
static_assert(max_contacts % sum_lanes == 0);

/// Motions and forces of contacts side by side.
struct Lanes {
    alignas(64) double along_x[max_contacts], along_y[max_contacts];  // from first to second node of the edge, m
    alignas(64) double from_x[max_contacts], from_y[max_contacts];    // from first to the node, m
    alignas(64) double node_x[max_contacts], node_y[max_contacts];    // displacement of the step, m
    alignas(64) double first_x[max_contacts], first_y[max_contacts], second_x[max_contacts], second_y[max_contacts];
    alignas(64) double tangent_x[max_contacts], tangent_y[max_contacts], inv_length[max_contacts];
    alignas(64) double place[max_contacts], depth[max_contacts];
    alignas(64) double force_x[3][max_contacts], force_y[3][max_contacts];
    alignas(64) double live[max_contacts], area[max_contacts], initial_overlap[max_contacts];
    alignas(64) double overlap[max_contacts], elastic_slip[max_contacts], release_correction[max_contacts];
    alignas(64) double normal_stiffness[max_contacts], shear_stiffness[max_contacts];
    alignas(64) double cohesion[max_contacts], tan_friction[max_contacts];
    alignas(64) double friction[max_contacts];
    alignas(64) double tan_fresh[max_contacts], inv_wear_slip[max_contacts], worn[max_contacts];  // set where faces wear
};

void gather(const Assemblage& a, const State& s, double time_step, Range contacts, Lanes& b) {
    const ActiveContacts& active = s.contact_pairs.active;
    const Vector2* const position = a.position.data();
    const Vector2* const displacement = s.displacement.data();
    const Vector2* const velocity = s.velocity.data();
    for (std::int32_t i = 0; i < contacts.size(); ++i) {
        const auto [node, first, second] = active.nodes[contacts.begin + i];
        const Vector2 on_first = position[first] + displacement[first];
        const Vector2 along = (position[second] + displacement[second]) - on_first;
        const Vector2 from_first = (position[node] + displacement[node]) - on_first;
        b.along_x[i] = along.x;
        b.along_y[i] = along.y;
        b.from_x[i] = from_first.x;
        b.from_y[i] = from_first.y;
        b.node_x[i] = time_step * velocity[node].x;
        b.node_y[i] = time_step * velocity[node].y;
        b.first_x[i] = time_step * velocity[first].x;
        b.first_y[i] = time_step * velocity[first].y;
        b.second_x[i] = time_step * velocity[second].x;
        b.second_y[i] = time_step * velocity[second].y;
        const NodeEdgeContact& contact = s.contact_pairs.contacts[active.pair[contacts.begin + i]];
        b.live[i] = contact.active ? 1 : 0;
        b.area[i] = contact.area;
        b.initial_overlap[i] = contact.initial_overlap;
        b.overlap[i] = contact.overlap;
        b.elastic_slip[i] = contact.elastic_slip;
        const FrictionLaw& law = active.laws[contacts.begin + i];
        b.normal_stiffness[i] = law.normal_stiffness;
        b.shear_stiffness[i] = law.shear_stiffness;
        b.cohesion[i] = law.cohesion;
        b.tan_friction[i] = law.tan_friction;
        if (s.worn.empty()) continue;
        b.tan_fresh[i] = law.tan_fresh;
        b.inv_wear_slip[i] = law.inv_wear_slip;
        b.worn[i] = s.worn[node];
    }
}

GRAINCRACK_INLINE void find_geometry(std::int32_t count, Lanes& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        const PairGeometry g = pair_geometry({b.along_x[i], b.along_y[i]}, {b.from_x[i], b.from_y[i]});
        b.tangent_x[i] = g.tangent.x;
        b.tangent_y[i] = g.tangent.y;
        b.inv_length[i] = g.inv_length;
        b.place[i] = g.place;
        b.depth[i] = g.depth;
    }
}

/// A contact ends when its node is outside and there is no overlap left. Its last force is the correction of its energy
/// (`NodeEdgeContact::release_correction`).
template <bool wears>
GRAINCRACK_INLINE void move(std::int32_t count, Lanes& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        const Vector2 t{b.tangent_x[i], b.tangent_y[i]};
        const PairGeometry g{t, {t.y, -t.x}, b.inv_length[i], b.place[i], b.depth[i]};
        const double sliding =
            sliding_along(g, {b.node_x[i], b.node_y[i]}, {b.first_x[i], b.first_y[i]}, {b.second_x[i], b.second_y[i]});
        FrictionLaw law{b.normal_stiffness[i], b.shear_stiffness[i], b.cohesion[i], b.tan_friction[i]};
        if constexpr (wears) {
            law.tan_fresh = b.tan_fresh[i];
            law.inv_wear_slip = b.inv_wear_slip[i];
        }
        const NodeEdgeResponse r =
            move_node_edge_contact<wears>(law, {true, true, b.area[i], b.initial_overlap[i], b.overlap[i], b.elastic_slip[i], 0},
                                          g, sliding, wears ? b.worn[i] : 0.0);
        if constexpr (wears) b.worn[i] = b.live[i] * std::abs(r.slip);
        const double live = b.live[i];
        b.live[i] = g.depth <= std::min(b.initial_overlap[i], 0.0) ? 0.0 : live;
        b.initial_overlap[i] = r.contact.initial_overlap;
        b.overlap[i] = r.contact.overlap;
        b.elastic_slip[i] = r.contact.elastic_slip;
        b.release_correction[i] = live * r.contact.release_correction;
        b.friction[i] = live * r.friction;
        b.force_x[0][i] = live * r.forces.on_node.x;
        b.force_y[0][i] = live * r.forces.on_node.y;
        b.force_x[1][i] = live * r.forces.on_first.x;
        b.force_y[1][i] = live * r.forces.on_first.y;
        b.force_x[2][i] = live * r.forces.on_second.x;
        b.force_y[2][i] = live * r.forces.on_second.y;
    }
}

void scatter(Range contacts, const Lanes& b, ContactPairList& list) {
    for (std::int32_t i = 0; i < contacts.size(); ++i) {
        const std::int32_t pair = list.active.pair[contacts.begin + i];
        list.contacts[pair] = {b.live[i] != 0,    b.place[i] < 0.5,       b.area[i], b.initial_overlap[i], b.overlap[i],
                               b.elastic_slip[i], b.release_correction[i]};
        Vector2* const forces = &list.forces[3 * static_cast<std::size_t>(pair)];
        for (std::int32_t k = 0; k < 3; ++k) forces[k] = {b.force_x[k][i], b.force_y[k][i]};
    }
}

}  // namespace

void move_active_contacts(const Assemblage& a, const StepParameters& parameters, std::int32_t chunk, State& s) {
    const std::int32_t begin = s.contact_pairs.first_watched(chunk);
    const std::int32_t end = begin + s.contact_pairs.active.count[chunk];
    Lanes b;
    for (std::int32_t at = begin; at < end; at += max_contacts) {
        const Range contacts{at, std::min(at + max_contacts, end)};
        gather(a, s, parameters.time_step, contacts, b);
        run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
            find_geometry(contacts.size(), b);
            s.worn.empty() ? move<false>(contacts.size(), b) : move<true>(contacts.size(), b);
        });
        scatter(contacts, b, s.contact_pairs);
        for (std::int32_t i = 0; !s.worn.empty() && i < contacts.size(); ++i) {
            s.worn[s.contact_pairs.active.nodes[at + i].front()] += b.worn[i];
        }
        s.contact_pairs.friction[s.contact_pairs.node_chunks[chunk]] += sum_values_by_lanes(contacts.size(), b.friction);
    }
}

void append_active(const Assemblage& a, const ContactLaws& laws, std::int32_t chunk, std::int32_t index, ContactPairList& list) {
    ActiveContacts& active = list.active;
    const std::int32_t at = list.first_watched(chunk) + active.count[chunk]++;
    const auto& [first, second] = a.surface.edges[list.pairs[index].edge].nodes;
    active.changed[chunk] = active.changed[chunk] != 0 || active.pair[at] != index ? 1 : 0;
    active.pair[at] = index;
    active.nodes[at] = {list.pairs[index].node, first, second};
    active.laws[at] = friction_law(a, laws, list.pairs[index]);
}

std::vector<double> energy_of_active_contacts(const Assemblage& a, const ContactLaws& laws, const ContactPairList& list) {
    std::vector<double> energy(a.node_chunks.size(), 0.0);
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(list.chunks.size()); ++chunk) {
        double& of_chunk = energy[list.node_chunks[chunk]];
        list.for_active_of(chunk, [&](std::int32_t i) {
            const std::int32_t pair = list.active.pair[i];
            const NodeEdgeContact& contact = list.contacts[pair];
            of_chunk += contact.active ? node_edge_energy(friction_law(a, laws, list.pairs[pair]), contact) : 0;
        });
    }
    return energy;
}

namespace {

/// Room for all watched pairs, none of which is active.
void clear_active(ContactPairList& list) {
    ActiveContacts& active = list.active;
    const std::size_t n = list.watched.size();
    active.pair.assign(n, -1);
    active.nodes.resize(n);
    active.laws.resize(n);
    active.count.assign(list.chunks.size(), 0);
    active.changed.assign(list.chunks.size(), 0);
}

}  // namespace

void load_active(const Assemblage& a, const ContactLaws& laws, ContactPairList& list) {
    clear_active(list);
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(list.chunks.size()); ++chunk) {
        const std::int32_t end = list.watched_groups[list.chunks[chunk].end - 1].end;
        for (std::int32_t i = list.first_watched(chunk); i < end; ++i) {
            if (list.contacts[list.watched[i]].is_at_work()) append_active(a, laws, chunk, list.watched[i], list);
        }
    }
    index_node_forces(a, list);
}

void resume_active(const Assemblage& a, const ContactLaws& laws, ContactPairList& list) {
    const std::vector<std::int32_t> pairs = list.active.pair;
    const std::vector<std::int32_t> counts = list.active.count;
    clear_active(list);
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(list.chunks.size()); ++chunk) {
        for (std::int32_t i = 0; i < counts[chunk]; ++i) {
            append_active(a, laws, chunk, pairs[list.first_watched(chunk) + i], list);
        }
    }
    index_node_forces(a, list);
}

void index_node_forces(const Assemblage& a, ContactPairList& list) {
    const ActiveContacts& active = list.active;
    const auto for_forces = [&](auto&& act) {
        list.for_active([&](std::int32_t i) {
            for (std::int32_t k = 0; k < 3; ++k) act(active.nodes[i][k], 3 * active.pair[i] + k);
        });
    };
    list.node_forces.clear();
    if (std::all_of(active.count.begin(), active.count.end(), [](std::int32_t count) { return count == 0; })) {
        std::fill(list.node_forces_of_chunk.begin(), list.node_forces_of_chunk.end(), Range{});
        return;
    }
    std::vector<std::int32_t>& end_of_node = list.node_force_scratch;  // where the next force of a node goes
    end_of_node.assign(a.position.size(), 0);
    std::int32_t total = 0;
    for_forces([&](std::int32_t node, std::int32_t /*slot*/) {
        ++end_of_node[node];
        ++total;
    });
    list.node_force_slots.resize(total);
    std::int32_t at = 0;
    for (std::size_t chunk = 0; chunk < a.node_chunks.size(); ++chunk) {
        const auto first = static_cast<std::int32_t>(list.node_forces.size());
        for (std::int32_t node = a.node_chunks[chunk].nodes.begin; node < a.node_chunks[chunk].nodes.end; ++node) {
            if (const std::int32_t count = end_of_node[node]; count > 0) {
                list.node_forces.push_back({node, {at, at + count}});
                end_of_node[node] = at;
                at += count;
            }
        }
        list.node_forces_of_chunk[chunk] = {first, static_cast<std::int32_t>(list.node_forces.size())};
    }
    for_forces([&](std::int32_t node, std::int32_t slot) { list.node_force_slots[end_of_node[node]++] = slot; });
}

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
