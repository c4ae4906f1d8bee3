#include "solver/step/mass_scaling_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "solver/simd.hpp"

namespace graincrack {
namespace {

static_assert(2 * nodes_per_chunk % sum_lanes == 0);

/// Forces and motions of the nodes of a chunk, x and y in turn.
struct Lanes {
    static constexpr std::int32_t size = 2 * nodes_per_chunk;
    alignas(64) double force[size], change[size], velocity[size];     ///< of the nodes; change of the force in a step
    alignas(64) double mean_acceleration[size], mean_velocity[size];  ///< of the cluster
    alignas(64) double mean_change[size];                             ///< change of their mean acceleration in a step
    alignas(64) double mean_damping_force[size];  ///< mean of the damping forces of the relative motion, per mass
    alignas(64) double damping_force[size];
};

Vector2 pair_at(const double* values, std::ptrdiff_t i) { return {values[2 * i], values[2 * i + 1]}; }
void set_pair(double* values, std::ptrdiff_t i, const Vector2& pair) {
    values[2 * i] = pair.x;
    values[2 * i + 1] = pair.y;
}

void gather(const MassScaling& scaling, Range nodes, const State& s, Lanes& b) {
    const Vector2* const force = s.force.data();
    const Vector2* const last_force = s.last_force.data();
    const Vector2* const velocity = s.velocity.data();
    for (std::int32_t i = 0; i < nodes.size(); ++i) {
        const std::int32_t node = scaling.nodes[nodes.begin + i];
        set_pair(b.force, i, force[node]);
        set_pair(b.change, i, force[node] - last_force[node]);
        set_pair(b.velocity, i, velocity[node]);
    }
}

/// Calls `act(cluster, places)` for every cluster of a chunk; places count from the chunk's first.
template <class Act>
void for_each_cluster(const MassScaling& scaling, std::int32_t chunk, const Act& act) {
    const Range clusters = scaling.chunks[chunk];
    const std::int32_t origin = scaling.clusters[clusters.begin].begin;
    for (std::int32_t cluster = clusters.begin; cluster < clusters.end; ++cluster) {
        act(cluster, Range{scaling.clusters[cluster].begin - origin, scaling.clusters[cluster].end - origin});
    }
}

/// Mean acceleration, its change and mean velocity of clusters.
void find_means(const MassScaling& scaling, std::int32_t chunk, const ClusterState& g, Lanes& b) {
    const double* const mass = &scaling.mass[2 * static_cast<std::size_t>(scaling.nodes_of(chunk).begin)];
    for_each_cluster(scaling, chunk, [&](std::int32_t cluster, Range nodes) {
        Vector2 force;
        Vector2 change;
        Vector2 momentum;
        for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
            force += pair_at(b.force, i);
            change += pair_at(b.change, i);
            momentum += mass[2 * i] * pair_at(b.velocity, i);
        }
        const double share = g.inverse_mass[cluster];
        const Vector2 acceleration = share * force;
        const Vector2 acceleration_change = share * change;
        const Vector2 velocity = share * momentum;
        for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
            set_pair(b.mean_acceleration, i, acceleration);
            set_pair(b.mean_change, i, acceleration_change);
            set_pair(b.mean_velocity, i, velocity);
        }
    });
}

/// Damping forces of the relative motion of each node.
GRAINCRACK_INLINE void damp_relative_motion(const double* mass, const Damping& shares, std::int32_t count, Lanes& b) {
    const Damping damping = shares;
    for (std::int32_t k = 0; k < count; ++k) {
        b.damping_force[k] = damping_force(damping, b.force[k] - mass[k] * b.mean_acceleration[k],
                                           b.change[k] - mass[k] * b.mean_change[k], b.velocity[k] - b.mean_velocity[k]);
    }
}

/// Mean of these damping forces over each cluster, to be subtracted.
void find_mean_damping_forces(const MassScaling& scaling, std::int32_t chunk, const ClusterState& g, Lanes& b) {
    for_each_cluster(scaling, chunk, [&](std::int32_t cluster, Range nodes) {
        Vector2 damping_force;
        for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
            damping_force += pair_at(b.damping_force, i);
        }
        const Vector2 mean = g.inverse_mass[cluster] * damping_force;
        for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
            set_pair(b.mean_damping_force, i, mean);
        }
    });
}

/// Damping forces of both motions into `damping_force`, and the damped mean acceleration.
GRAINCRACK_INLINE void damp_mean_motion(const double* mass, const Damping& shares, std::int32_t count, Lanes& b) {
    const Damping damping = shares;
    for (std::int32_t k = 0; k < count; ++k) {
        const double mean = damping_force(damping, b.mean_acceleration[k], b.mean_change[k], b.mean_velocity[k]);
        b.damping_force[k] += mass[k] * (mean - b.mean_damping_force[k]);
        b.mean_acceleration[k] += mean;
    }
}

/// Damping forces and damped mean accelerations of a chunk. The mean motion of a cluster that a platen constrains is the
/// platen's, and is not damped.
void damp(const Assemblage& a, const StepParameters& parameters, const PlatenVelocities& platens, std::int32_t chunk,
          const State& s, Lanes& b) {
    const MassScaling& scaling = parameters.mass_scaling;
    const Range nodes = scaling.nodes_of(chunk);
    const std::int32_t count = 2 * nodes.size();
    const double* const mass = &scaling.mass[2 * static_cast<std::size_t>(nodes.begin)];
    gather(scaling, nodes, s, b);
    find_means(scaling, chunk, s.clusters, b);
    for (const auto& [i, constraining_platen] : s.clusters.constrained[chunk]) {
        set_pair(b.mean_velocity, i, platens[constraining_platen]);
    }
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { damp_relative_motion(mass, parameters.damps(), count, b); });
    find_mean_damping_forces(scaling, chunk, s.clusters, b);
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { damp_mean_motion(mass, parameters.damps(), count, b); });
}

/// v += Δt M'⁻¹ (F + Fd). \return twice the energy absorbed by damping over Δt, W
GRAINCRACK_INLINE double accelerate(const double* inverse_mass, double own, double time_step, std::int32_t count, Lanes& b) {
    for (std::int32_t k = count; k < in_whole_lanes(count); ++k) {
        b.damping_force[k] = b.velocity[k] = b.mean_velocity[k] = 0;
    }
    // The new velocities go into `mean_velocity`, which is not needed any more.
    for (std::int32_t k = 0; k < count; ++k) {
        const double mean = (1 - own) * b.mean_acceleration[k];
        b.mean_velocity[k] = b.velocity[k] + time_step * (mean + (own * inverse_mass[k]) * (b.force[k] + b.damping_force[k]));
    }
    return -sum_by_lanes(
        count, [&](std::int32_t k) GRAINCRACK_KERNEL { return b.damping_force[k] * (b.velocity[k] + b.mean_velocity[k]); });
}

/// Acceleration of the platen that constrains a cluster, m/s².
Vector2 platen_acceleration(const StepLoading& loading, double time_step, std::uint8_t constraining_platen) {
    const std::size_t platen = constraining_platen - 1U;
    return {0, (loading.increment_after[platen] - loading.increment_before[platen]) / (time_step * time_step)};
}

}  // namespace

void damp_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                   State& s) {
    Lanes b;
    damp(a, parameters, PlatenVelocities(loading, parameters.time_step), chunk, s, b);
    const Range nodes = parameters.mass_scaling.nodes_of(chunk);
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        s.damping_force[parameters.mass_scaling.nodes[i]] = pair_at(b.damping_force, i - nodes.begin);
    }
}

void integrate_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                        State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const double dt = parameters.time_step;
    Lanes b;
    damp(a, parameters, PlatenVelocities(loading, dt), chunk, s, b);
    for (const auto& [i, constraining_platen] : s.clusters.constrained[chunk]) {
        set_pair(b.mean_acceleration, i, platen_acceleration(loading, dt, constraining_platen));
    }
    const Range nodes = scaling.nodes_of(chunk);
    const double* const inverse_mass = &scaling.inverse_mass[2 * static_cast<std::size_t>(nodes.begin)];
    double absorbed = 0;
    run_on(a.vector_target,
           [&]() GRAINCRACK_KERNEL { absorbed = accelerate(inverse_mass, 1 / (1 + scaling.factor), dt, 2 * nodes.size(), b); });
    s.clusters.sums[chunk].damping += 0.5 * dt * absorbed;
    for (const auto& [i, constraining_platen] : s.clusters.constrained[chunk]) {
        const Vector2 against_platen = (1 / dt) * (pair_at(b.mean_velocity, i) - pair_at(b.velocity, i)) -
                                       platen_acceleration(loading, dt, constraining_platen);
        const double force = -scaling.factor * scaling.mass[2 * (nodes.begin + i)] * against_platen.y;  // of the added mass
        s.clusters.sums[chunk].platen_work +=
            0.5 * force *
            (loading.increment_before[constraining_platen - 1U] + loading.increment_after[constraining_platen - 1U]);
    }
    Vector2* const velocity = s.velocity.data();
    Vector2* const displacement = s.displacement.data();
    for (std::int32_t i = 0; i < nodes.size(); ++i) {
        const std::int32_t node = scaling.nodes[nodes.begin + i];
        const Vector2 moved = pair_at(b.mean_velocity, i);
        velocity[node] = moved;
        displacement[node] += dt * moved;
        s.last_force[node] = s.force[node];
    }
}

}  // namespace graincrack
