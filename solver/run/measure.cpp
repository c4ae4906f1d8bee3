#include "solver/run/measure.hpp"

#include <vector>

#include "solver/detection/active_contacts.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "solver/step/prescribed.hpp"

namespace graincrack {
namespace {

/// As `sum_over_chunks`, with the chunks shared by a team.
template <class OfChunk>
auto sum_of_team(ThreadTeam& team, const Part& part, const ChunkShare& chunks, const OfChunk& of_chunk) {
    std::vector<decltype(of_chunk(0))> shares(static_cast<std::size_t>(chunks.count));
    for_each_of_team(team, chunks.own.size(), [&](std::size_t i) { shares[chunks.own[i]] = of_chunk(chunks.own[i]); });
    return sum_over_chunks(part, chunks, [&](std::int32_t chunk) { return shares[chunk]; });
}

/// Damping of the nodes of a chunk at this instant, into `damping_force`.
void find_damping_forces(const Assemblage& a, const StepParameters& parameters, std::int32_t chunk, State& s) {
    if (parameters.mass_scaling.is_on()) {
        update_clusters(a, parameters, s.loading, chunk, s);
        damp_clusters(a, parameters, s.loading, chunk, s);
        return;
    }
    const Range nodes = a.node_chunks[chunk].nodes;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        s.damping_force[i] = damping_force(parameters.damps(), s.force[i], s.force[i] - s.last_force[i], s.velocity[i]);
    }
}

void add_motion(const Assemblage& a, const StepParameters& parameters, Range nodes, const State& s, Measurement& share) {
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const Vector2 force = s.force[i] + s.damping_force[i];
        const Vector2 new_velocity = s.velocity[i] + (parameters.time_step * a.inverse_mass[i]) * force;
        share.own_kinetic += 0.5 * a.mass[i] * dot(s.velocity[i], new_velocity);
        share.energies.damping -= 0.5 * parameters.time_step * dot(s.damping_force[i], s.velocity[i]);
        share.unbalanced_ratio += length(s.force[i]);
    }
    share.energies.kinetic += share.own_kinetic;
}

void add_booked(std::int32_t chunk, const State& s, Energies& energies) {
    const NodeSums& sums = s.node_sums[chunk];
    energies.damping += sums.damping;
    energies.external += sums.platen_work + sums.load_work + sums.reaction_work;
    energies.platen += sums.platen_friction;
    energies.friction += s.contact_pairs.friction[chunk];
}

void add_clusters(const Assemblage& a, const StepParameters& parameters, std::int32_t chunk, const State& s, Energies& energies) {
    if (!parameters.mass_scaling.is_on()) return;
    energies.kinetic += added_kinetic_energy(a, parameters, s.loading, chunk, s);
    const ClusterSums& sums = s.clusters.sums[chunk];
    energies.damping += sums.damping;
    energies.numerical += sums.platen_loss;
    energies.external += sums.platen_work;
}

/// Energy that the platens keep, work of their last half step, their power and their forces.
void add_platens(const Boundary& boundary, double time_step, std::int32_t chunk, const State& s, Measurement& share) {
    const Range points = boundary.platen_points_of_chunk[chunk];
    for (std::int32_t i = points.begin; i < points.end; ++i) {
        const PlatenPoint& point = s.platen_points[i];
        const Platen& platen = boundary.platens[point.platen];
        const PlatenResponse r =
            platen_response(platen, point, s.displacement[point.node], s.loading.platen_displacement[platen.motion]);
        const double force = dot(r.force, platen.axis);
        const double increment = s.loading.increment_before[platen.motion];
        share.energies.platen += r.stored + r.friction;
        share.energies.external += 0.5 * force * increment;
        share.platen_power += force * increment / time_step;
        (platen.motion == top_platen ? share.force_top : share.force_bottom) += force;
    }
}

void add_prescribed(const Assemblage& a, const PrescribedConditions& prescribed, double time_step, std::int32_t chunk,
                    const State& s, Measurement& share) {
    if (prescribed.empty()) return;
    share.energies.external += load_half_work(a, prescribed, chunk, time_step, s);
    share.energies.external += reaction_half_work(prescribed, chunk, time_step, s);
    // Two ends an edge, two sides: the mean of the sides.
    share.confining_force += sum_over(prescribed.edges_of_chunk[chunk], [&](std::int32_t i) {
        return prescribed.edges[i].is_lateral ? s.prescribed.lateral[i] : 0;
    });
}

/// What the nodes give of a measurement, found on the way, with Σ |unbalanced force| (N) in place of the ratio.
Measurement sum_over_nodes(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, ThreadTeam& team,
                           State& s) {
    const std::vector<double> stored = energy_of_active_contacts(a, parameters.laws, s.contact_pairs);
    return sum_of_team(team, a.part, a.part.nodes, [&](std::int32_t chunk) {
        find_damping_forces(a, parameters, chunk, s);
        Measurement share;
        add_motion(a, parameters, a.node_chunks[chunk].nodes, s, share);
        add_booked(chunk, s, share.energies);
        add_clusters(a, parameters, chunk, s, share.energies);
        add_platens(boundary, parameters.time_step, chunk, s, share);
        add_prescribed(a, boundary.prescribed, parameters.time_step, chunk, s, share);
        share.energies.contact += stored[chunk];
        return share;
    });
}

/// Strain energy (J) and Σ |force on a node| over the nodes (N) of elements.
struct ElementSums {
    double energy = 0, force = 0;
    using IsSum = void;
};
template <class StateOf>
ElementSums sum_over_elements(const Assemblage& a, Range elements, const StateOf& state_of) {
    return sum_over(elements, [&](std::int32_t e) {
        const TriangleGeometry g = a.element_geometry[e];
        const TriangleState t = state_of(e);
        const TriangleForces f = triangle_forces(g, t);
        return ElementSums{triangle_energy(g, t), length(f.on_node0()) + length(f.on_node1) + length(f.on_node2)};
    });
}
/// Of elements, with the work of temperature (J).
struct WarmSums {
    ElementSums elastic;
    double thermal_work = 0;
    using IsSum = void;
};
WarmSums sum_over_elements(const Assemblage& a, ThreadTeam& team, const State& s) {
    return sum_of_team(team, a.part, a.part.elements, [&](std::int32_t chunk) {
        const Range elements = a.element_chunks[chunk];
        if (s.thermal.empty()) {
            return WarmSums{sum_over_elements(a, elements, [&](std::int32_t e) { return cold_element_state(a, e, s); })};
        }
        WarmSums sums{sum_over_elements(a, elements, [&](std::int32_t e) { return element_state(a, e, s); }),
                      s.thermal[chunk].work};
        sums.elastic.energy += sum_over(elements, [&](std::int32_t e) {
            return a.element_geometry.area[e] * a.expansion.of_element(e, s.loading.temperature).energy_zz;
        });
        return sums;
    });
}

Energies energies_of_contacts(const Assemblage& a, const ContactLaws& laws, ThreadTeam& team, const State& s) {
    return sum_of_team(team, a.part, a.part.contacts, [&](std::int32_t chunk) {
        const ContactSums& booked = s.contact_sums[chunk];
        return Energies{.contact = stored_in_chunk(a, laws, chunk, s),
                        .fracture_tension = booked.fracture_tension,
                        .fracture_shear = booked.fracture_shear,
                        .friction = booked.friction,
                        .non_conservative_work = booked.non_conservative_work};
    });
}

}  // namespace

Measurement measure(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, ThreadTeam& team, State& s) {
    sum_nodal_forces(a, boundary, s.loading, team, s);
    Measurement m = sum_over_nodes(a, boundary, parameters, team, s);
    const auto [elements, thermal_work] = sum_over_elements(a, team, s);
    m.energies += energies_of_contacts(a, parameters.laws, team, s);
    m.energies.strain = elements.energy;
    m.energies.external += thermal_work;
    m.element_force = elements.force;
    m.unbalanced_ratio = elements.force > 0 ? m.unbalanced_ratio / elements.force : 0;
    return m;
}

}  // namespace graincrack
