#include "solver/step/nodal_forces.hpp"

#include <algorithm>
#include <array>

#include "solver/arithmetic/simd.hpp"
#include "solver/step/element_forces.hpp"
#include "solver/step/prescribed.hpp"

namespace graincrack {
namespace {

/// Adds the forces in further slots of the nodes of a chunk. \param to_y from the x of a slot to its y
template <std::size_t few>
void add_further(const SlotsOfNodes<few>& slots, const std::vector<double>& value, std::int32_t to_y, std::int32_t chunk,
                 State& s) {
    const Range further = slots.further_of_chunk[chunk];
    for (std::int32_t i = further.begin; i < further.end; ++i) {
        const auto [node, slot] = slots.further[i];
        s.force[node] += {value[slot], value[slot + to_y]};
    }
}

/// Sets `state.force` on the nodes of a chunk to the forces of elements and contacts.
void gather_elements_and_contacts(const Assemblage& a, std::int32_t chunk, State& s) {
    const double* const of_element = s.element_force.data();
    const double* const of_contact = s.contact_force.data();
    const std::array<std::int32_t, 1>* const element_slots = a.element_slots.first.data();
    const std::array<std::int32_t, 2>* const contact_slots = a.contact_slots.first.data();
    Vector2* const force = s.force.data();
    const Range nodes = a.node_chunks[chunk].nodes;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const auto [element] = element_slots[i];
        const auto [first, second] = contact_slots[i];
        force[i] = {of_element[element] + (of_contact[first] + of_contact[second]),
                    of_element[element + elements_per_chunk] +
                        (of_contact[first + contacts_per_chunk] + of_contact[second + contacts_per_chunk])};
    }
    add_further(a.element_slots, s.element_force, elements_per_chunk, chunk, s);
    add_further(a.contact_slots, s.contact_force, contacts_per_chunk, chunk, s);
}

void add_active_contacts(std::int32_t chunk, State& s) {
    const ContactPairList& list = s.contact_pairs;
    const Range node_forces = list.node_forces_of_chunk[chunk];
    for (std::int32_t i = node_forces.begin; i < node_forces.end; ++i) {
        const NodeForces& gather = list.node_forces[i];
        for (std::int32_t k = gather.slots.begin; k < gather.slots.end; ++k) {
            s.force[gather.node] += list.forces[list.node_force_slots[k]];
        }
    }
}

/// Adds the forces of the platens. \param visit called with each platen point and its response
template <class Visit>
void add_platens(const Boundary& boundary, const StepLoading& loading, std::int32_t chunk, State& s, const Visit& visit) {
    const Range points = boundary.platen_points_of_chunk[chunk];
    for (std::int32_t i = points.begin; i < points.end; ++i) {
        PlatenPoint& point = s.platen_points[i];
        const Platen& platen = boundary.platens[point.platen];
        const Vector2& u = s.displacement[point.node];
        const double platen_displacement = loading.platen_displacement[platen.motion];
        const PlatenResponse r = platen_response(platen, point, u, platen_displacement);
        s.force[point.node] += r.force;
        const double penetration = platen_penetration(platen, point, u, platen_displacement);
        if ((platen.bonded && !point.is_absent()) || penetration > -platen_reach * point.tributary) {
            s.near_platen[point.node] = static_cast<std::uint8_t>(1 + platen.motion);
        }
        visit(point, r);
    }
}

/// Sums the forces on the nodes of a chunk in a fixed order. \param visit called with each platen point and its response
template <class Visit>
void sum_forces(const Assemblage& a, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk, State& s,
                const Visit& visit) {
    const Range nodes = a.node_chunks[chunk].nodes;
    std::fill(s.near_platen.begin() + nodes.begin, s.near_platen.begin() + nodes.end, std::uint8_t{0});
    gather_elements_and_contacts(a, chunk, s);
    add_active_contacts(chunk, s);
    add_platens(boundary, loading, chunk, s, visit);
    if (!boundary.prescribed.empty()) add_prescribed(a, boundary.prescribed, loading, chunk, s);
}

/// Integrates nodes: v += Δt (F + Fd)/m, u += Δt v. \return energy absorbed by damping, J
GRAINCRACK_INLINE double move_nodes(std::int32_t count, double time_step, const Damping& shares, const double* inverse_mass,
                                    const Vector2* force, Vector2* last_force, Vector2* velocity, Vector2* displacement) {
    const Damping damping = shares;
    double absorbed = 0;
    for (std::int32_t i = 0; i < count; ++i) {
        const Vector2 old_velocity = velocity[i];
        const Vector2 resistance = damping_force(damping, force[i], force[i] - last_force[i], old_velocity);
        last_force[i] = force[i];
        const double rate = time_step * inverse_mass[i];
        const Vector2 new_velocity{old_velocity.x + rate * (force[i].x + resistance.x),
                                   old_velocity.y + rate * (force[i].y + resistance.y)};
        velocity[i] = new_velocity;
        displacement[i].x += time_step * new_velocity.x;
        displacement[i].y += time_step * new_velocity.y;
        absorbed -= resistance.x * (old_velocity.x + new_velocity.x) + resistance.y * (old_velocity.y + new_velocity.y);
    }
    return 0.5 * time_step * absorbed;
}

}  // namespace

void sum_nodal_forces(const Assemblage& a, const Boundary& boundary, const StepLoading& loading, ThreadTeam& team, State& s) {
    Warmth warmth;
    if (!s.thermal.empty()) warmth.go_to(loading.temperature, a.expansion);
    for (const auto* chunks : {&a.part.evaluated_elements.inner, &a.part.evaluated_elements.outer}) {
        for_each_of_team(team, chunks->size(), [&](std::size_t i) { find_element_forces(a, warmth, (*chunks)[i], s); });
    }
    for (const std::int32_t chunk : a.part.loaded_chunks) find_edge_loads(a, boundary.prescribed, loading, chunk, s);
    for_each_of_team(team, a.part.nodes.own.size(), [&](std::size_t i) {
        sum_forces(a, boundary, loading, a.part.nodes.own[i], s, [](const PlatenPoint&, const PlatenResponse&) {});
    });
}

void advance_nodal_forces(const Assemblage& a, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk,
                          State& s) {
    NodeSums& sums = s.node_sums[chunk];
    sum_forces(a, boundary, loading, chunk, s, [&](PlatenPoint& point, const PlatenResponse& r) {
        point.anchor = r.anchor;
        point.shear = r.shear;
        sums.platen_friction += r.friction;
        const Platen& platen = boundary.platens[point.platen];
        const double increments = loading.increment_before[platen.motion] + loading.increment_after[platen.motion];
        sums.platen_work += 0.5 * dot(r.force, platen.axis) * increments;
    });
}

void book_half_load_work(const Assemblage& a, const Boundary& boundary, std::int32_t chunk, double time_step, State& s) {
    if (!boundary.prescribed.empty()) s.node_sums[chunk].load_work += load_half_work(a, boundary.prescribed, chunk, time_step, s);
}

void integrate_nodes(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, std::int32_t chunk,
                     State& s) {
    const Range nodes = a.node_chunks[chunk].nodes;
    NodeSums& sums = s.node_sums[chunk];
    const double dt = parameters.time_step;
    record_prescribed(boundary.prescribed, chunk, s);
    const std::int32_t n = nodes.size();
    double absorbed = 0;
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        absorbed = move_nodes(n, dt, parameters.damps(), &a.inverse_mass[nodes.begin], &s.force[nodes.begin],
                              &s.last_force[nodes.begin], &s.velocity[nodes.begin], &s.displacement[nodes.begin]);
    });
    sums.damping += absorbed;
    sums.reaction_work += move_prescribed(a, boundary.prescribed, chunk, dt, s);
}

}  // namespace graincrack
