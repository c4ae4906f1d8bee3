#include "solver/run/measure.hpp"

#include <cmath>

#include "solver/step/contact_energy.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "solver/step/prescribed.hpp"

namespace graincrack {
namespace {

/// Damping at this instant, into `damping_force`.
void find_damping_forces(const Assemblage& a, const StepParameters& parameters, State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    if (scaling.is_on()) {
        for (const std::int32_t chunk : a.part.nodes.own) {
            update_clusters(a, parameters, s.loading, chunk, s);
            damp_clusters(a, parameters, s.loading, chunk, s);
        }
        return;
    }
    const Range nodes = a.part.own_nodes();
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        s.damping_force[i] = damping_force(parameters.damps(), s.force[i], s.force[i] - s.last_force[i], s.velocity[i]);
    }
}

double kinetic_energy(const Assemblage& a, const StepParameters& parameters, const State& s) {
    return 0.5 * sum_over_nodes(a, [&](std::int32_t i) {
               const Vector2 force = s.force[i] + s.damping_force[i];
               return a.mass[i] * dot(s.velocity[i], s.velocity[i] + (parameters.time_step * a.inverse_mass[i]) * force);
           });
}

double damping_half_work(const Assemblage& a, const StepParameters& parameters, const State& s) {
    return -0.5 * parameters.time_step *
           sum_over_nodes(a, [&](std::int32_t i) { return dot(s.damping_force[i], s.velocity[i]); });
}

/// Strain energy (J) and Σ |force on a node| over the nodes (N) of elements.
struct ElementSums {
    double energy = 0, force = 0;
    ElementSums& operator+=(const ElementSums& other) {
        energy += other.energy;
        force += other.force;
        return *this;
    }
};
ElementSums sum_over_elements(const Assemblage& a, const State& s) {
    return sum_over_chunks(a.part, a.part.elements, [&](std::int32_t chunk) {
        return sum_over(a.element_chunks[chunk], [&](std::int32_t e) {
            const TriangleGeometry g = a.element_geometry[e];
            const TriangleState t = element_state(a, e, s);
            const TriangleForces f = triangle_forces(g, t);
            return ElementSums{triangle_energy(g, t), length(f.on_node0()) + length(f.on_node1) + length(f.on_node2)};
        });
    });
}

void add_contact_energies(const Assemblage& a, const ContactLaws& laws, const State& s, Energies& energies) {
    energies.contact += stored_in_contacts(a, laws, s);
    const ContactSums sums =
        sum_over_chunks(a.part, a.part.contacts, [&](std::int32_t chunk) { return s.contact_sums[chunk]; });
    energies.fracture_tension += sums.fracture_tension;
    energies.fracture_shear += sums.fracture_shear;
    energies.friction += sums.friction;
    energies.non_conservative_work += sums.non_conservative_work;
}

void add_node_energies(const Assemblage& a, const State& s, Energies& energies) {
    const NodeSums sums = sum_over_chunks(a.part, a.part.nodes, [&](std::int32_t chunk) { return s.node_sums[chunk]; });
    energies.damping += sums.damping;
    energies.external += sums.platen_work + sums.load_work + sums.reaction_work;
    energies.platen += sums.platen_friction;
    energies.friction +=
        sum_over_chunks(a.part, a.part.nodes, [&](std::int32_t chunk) { return s.contact_pairs.friction[chunk]; });
}

void add_cluster_energies(const Assemblage& a, const StepParameters& parameters, const State& s, Energies& energies) {
    if (!parameters.mass_scaling.is_on()) return;
    energies.kinetic += sum_over_chunks(
        a.part, a.part.nodes, [&](std::int32_t chunk) { return added_kinetic_energy(a, parameters, s.loading, chunk, s); });
    const ClusterSums sums = sum_over_chunks(a.part, a.part.nodes, [&](std::int32_t chunk) { return s.clusters.sums[chunk]; });
    energies.damping += sums.damping;
    energies.numerical += sums.platen_loss;
    energies.external += sums.platen_work;
}

/// What the platens do: energy they keep (J), work of the last half step (J), power (W), forces along the axis by motion (N).
struct PlatenSums {
    double energy = 0, half_work = 0, power = 0;
    std::array<double, 2> force{};
    PlatenSums& operator+=(const PlatenSums& other) {
        energy += other.energy;
        half_work += other.half_work;
        power += other.power;
        force[bottom_platen] += other.force[bottom_platen];
        force[top_platen] += other.force[top_platen];
        return *this;
    }
};
void add_platen_energies(const Assemblage& a, const Boundary& boundary, double time_step, const State& s, Measurement& m) {
    const PlatenSums sums = sum_by_nodes(a, boundary.platen_points_of_chunk, [&](std::int32_t i) {
        const PlatenPoint& point = s.platen_points[i];
        const Platen& platen = boundary.platens[point.platen];
        const PlatenResponse r =
            platen_response(platen, point, s.displacement[point.node], s.loading.platen_displacement[platen.motion]);
        const double force = dot(r.force, platen.axis);
        const double increment = s.loading.increment_before[platen.motion];
        PlatenSums of_point{r.stored + r.friction, 0.5 * force * increment, force * increment / time_step};
        of_point.force[platen.motion] = force;
        return of_point;
    });
    m.energies.platen += sums.energy;
    m.energies.external += sums.half_work;
    m.platen_power += sums.power;
    m.force_bottom += sums.force[bottom_platen];
    m.force_top += sums.force[top_platen];
}

void add_prescribed_energies(const Assemblage& a, const PrescribedConditions& prescribed, double time_step, const State& s,
                             Measurement& m) {
    if (prescribed.empty()) return;
    m.energies.external += sum_over_chunks(
        a.part, a.part.nodes, [&](std::int32_t chunk) { return load_half_work(a, prescribed, chunk, time_step, s); });
    m.energies.external += reaction_half_work(a, prescribed, time_step, s);
    // Two ends an edge, two sides: the mean of the sides.
    m.confining_force += sum_by_nodes(a, prescribed.edges_of_chunk, [&](std::int32_t i) {
        return prescribed.edges[i].is_lateral ? s.prescribed.lateral[i] : 0;
    });
}

}  // namespace

Measurement measure(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, State& s) {
    Measurement m;
    sum_nodal_forces(a, boundary, s.loading, s);
    const ElementSums elements = sum_over_elements(a, s);
    m.energies.strain = elements.energy;
    find_damping_forces(a, parameters, s);
    m.own_kinetic = kinetic_energy(a, parameters, s);
    const double unbalanced = sum_over_nodes(a, [&](std::int32_t i) { return length(s.force[i]); });
    m.energies.kinetic = m.own_kinetic;
    m.energies.damping = damping_half_work(a, parameters, s);
    add_cluster_energies(a, parameters, s, m.energies);
    m.unbalanced_ratio = elements.force > 0 ? unbalanced / elements.force : 0;
    add_contact_energies(a, parameters.laws, s, m.energies);
    add_platen_energies(a, boundary, parameters.time_step, s, m);
    add_prescribed_energies(a, boundary.prescribed, parameters.time_step, s, m);
    add_node_energies(a, s, m.energies);
    return m;
}

}  // namespace graincrack
