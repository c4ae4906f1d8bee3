#include "solver/step/nodal_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/simd.hpp"
#include "solver/step/prescribed.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t max_lanes = 64;  ///< elements that a vector kernel works on at a time

/// Elements side by side: edge displacements in, nodal forces out.
struct Lanes {
    alignas(64) double a_x[max_lanes], a_y[max_lanes], b_x[max_lanes], b_y[max_lanes];
    alignas(64) double f1_x[max_lanes], f1_y[max_lanes], f2_x[max_lanes], f2_y[max_lanes];
};

/// Geometry and elasticity of elements side by side.
struct Triangles {
    const double *gradient1_x, *gradient1_y, *gradient2_x, *gradient2_y, *area;
    const double *c11, *c12, *mu;
};
Triangles triangles_from(const Assemblage& a, std::int32_t e) {
    const TriangleTable& t = a.element_geometry;
    const ElasticityTable& c = a.elasticity;
    return {&t.gradient1_x[e], &t.gradient1_y[e], &t.gradient2_x[e], &t.gradient2_y[e],
            &t.area[e],        &c.c11[e],         &c.c12[e],         &c.mu[e]};
}

GRAINCRACK_INLINE void find_element_forces(const Triangles& triangles, std::int32_t count, Lanes& b) {
    const Triangles t = triangles;
    for (std::int32_t i = 0; i < count; ++i) {
        const TriangleGeometry g{{t.gradient1_x[i], t.gradient1_y[i]}, {t.gradient2_x[i], t.gradient2_y[i]}, t.area[i]};
        const PlaneElasticity c{t.c11[i], t.c12[i], t.mu[i], 0};
        const TriangleForces f = triangle_forces(g, triangle_state(g, c, {b.a_x[i], b.a_y[i]}, {b.b_x[i], b.b_y[i]}));
        b.f1_x[i] = f.on_node1.x;
        b.f1_y[i] = f.on_node1.y;
        b.f2_x[i] = f.on_node2.x;
        b.f2_y[i] = f.on_node2.y;
    }
}

void add_elements(const Assemblage& a, Range range, State& s) {
    Lanes b;
    for (std::int32_t begin = range.begin; begin < range.end; begin += max_lanes) {
        const std::int32_t count = std::min(max_lanes, range.end - begin);
        const std::array<std::int32_t, 3>* const nodes = &a.element_nodes[begin];
        const Vector2* const displacement = s.displacement.data();
        for (std::int32_t i = 0; i < count; ++i) {
            const auto [n0, n1, n2] = nodes[i];
            const Vector2 u0 = displacement[n0];
            const Vector2 to1 = displacement[n1] - u0;
            const Vector2 to2 = displacement[n2] - u0;
            b.a_x[i] = to1.x;
            b.a_y[i] = to1.y;
            b.b_x[i] = to2.x;
            b.b_y[i] = to2.y;
        }
        const Triangles triangles = triangles_from(a, begin);
        run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { find_element_forces(triangles, count, b); });
        Vector2* const force = s.force.data();
        for (std::int32_t i = 0; i < count; ++i) {
            const auto [n0, n1, n2] = nodes[i];
            const Vector2 f1{b.f1_x[i], b.f1_y[i]};
            const Vector2 f2{b.f2_x[i], b.f2_y[i]};
            force[n0] -= f1 + f2;
            force[n1] += f1;
            force[n2] += f2;
        }
    }
}

/// Sets `state.force` on the nodes of a chunk to the forces of contacts.
void gather_contacts(const Assemblage& a, const GrainChunk& chunk, State& s) {
    const double* const value = s.contact_force.data();
    const std::array<std::int32_t, 2>* const slots = a.slots.data();
    Vector2* const force = s.force.data();
    for (std::int32_t i = chunk.nodes.begin; i < chunk.nodes.end; ++i) {
        const auto [first, second] = slots[i];
        force[i] = {value[first] + value[second], value[first + contacts_per_chunk] + value[second + contacts_per_chunk]};
    }
    for (std::int32_t i = chunk.further_slots.begin; i < chunk.further_slots.end; ++i) {
        const auto [node, slot] = a.further_slots[i];
        s.force[node] += {value[slot], value[slot + contacts_per_chunk]};
    }
}

void add_active_contacts(std::int32_t chunk, State& s) {
    const ContactPairList& list = s.contact_pairs;
    const Range node_forces = list.node_forces_of_chunk[chunk];
    for (std::int32_t i = node_forces.begin; i < node_forces.end; ++i) {
        const NodeForces& gather = list.node_forces[i];
        for (std::int32_t k = gather.slots.begin; k < gather.slots.end; ++k) {
            s.force[gather.node] += list.active.forces[list.node_force_slots[k]];
        }
    }
}

/// Adds the forces of the platens; calls `visit` with each platen point and the response to it.
template <class Visit>
void add_platens(const Boundary& boundary, const StepLoading& loading, std::int32_t chunk, State& s, const Visit& visit) {
    const Range points = boundary.platen_points_of_chunk[chunk];
    for (std::int32_t i = points.begin; i < points.end; ++i) {
        PlatenPoint& point = s.platen_points[i];
        const Platen& platen = boundary.platens[point.platen];
        const Vector2& u = s.displacement[point.node];
        const double platen_displacement = loading.platen_displacement[point.platen];
        const PlatenResponse r = platen_response(platen, point, u, platen_displacement);
        s.force[point.node] += r.force;
        const double penetration = platen_penetration(platen, point, u, platen_displacement);
        if (platen.bonded || penetration > -platen_reach * point.tributary) {
            s.near_platen[point.node] = static_cast<std::uint8_t>(1 + point.platen);
        }
        visit(point, r);
    }
}

/// The forces on the nodes of a chunk, in a fixed order. \param visit called with each platen point and the response to it
template <class Visit>
void sum_forces(const Assemblage& a, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk, State& s,
                const Visit& visit) {
    const GrainChunk& range = a.grain_chunks[chunk];
    std::fill(s.near_platen.begin() + range.nodes.begin, s.near_platen.begin() + range.nodes.end, std::uint8_t{0});
    gather_contacts(a, range, s);
    add_elements(a, range.elements, s);
    add_active_contacts(chunk, s);
    add_platens(boundary, loading, chunk, s, visit);
    if (!boundary.prescribed.empty()) {
        add_prescribed(a, boundary.prescribed, loading, chunk, s);
    }
}

/// v += Δt (F + Fd)/m, u += Δt v. \return energy absorbed by damping, J
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

void sum_nodal_forces(const Assemblage& a, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk, State& s) {
    sum_forces(a, boundary, loading, chunk, s, [](const PlatenPoint&, const PlatenResponse&) {});
}

void advance_nodal_forces(const Assemblage& a, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk,
                          State& s) {
    GrainSums& sums = s.grain_sums[chunk];
    sum_forces(a, boundary, loading, chunk, s, [&](PlatenPoint& point, const PlatenResponse& r) {
        point.anchor = r.anchor;
        point.shear = r.shear;
        sums.platen_friction += r.friction;
        sums.platen_work += 0.5 * r.force.y * (loading.increment_before[point.platen] + loading.increment_after[point.platen]);
    });
}

void book_half_load_work(const Assemblage& a, const Boundary& boundary, std::int32_t chunk, double time_step, State& s) {
    if (!boundary.prescribed.empty()) {
        s.grain_sums[chunk].load_work += load_half_work(a, boundary.prescribed, chunk, time_step, s);
    }
}

void integrate_nodes(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, std::int32_t chunk,
                     State& s) {
    const Range nodes = a.grain_chunks[chunk].nodes;
    GrainSums& sums = s.grain_sums[chunk];
    const double dt = parameters.time_step;
    note_prescribed(boundary.prescribed, chunk, s);
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
