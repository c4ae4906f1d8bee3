#include "solver/step/mass_scaling_step.hpp"

#include <cstddef>

#include "solver/arithmetic/simd.hpp"

namespace graincrack {
namespace {

static_assert(2 * nodes_per_chunk % sum_lanes == 0);
static_assert(sizeof(Vector2) == 2 * sizeof(double));

/// The components x and y of successive vectors, alternating.
const double* components(const Vector2& first) { return &first.x; }
double* components(Vector2& first) { return &first.x; }

/// Arrays of the nodes of a chunk, with x and y alternating.
struct Nodes {
    const double *force, *last_force, *velocity, *mass, *inverse_mass;
};
Nodes nodes_from(const MassScaling& scaling, std::int32_t node, const State& s) {
    const auto first = 2 * static_cast<std::size_t>(node);
    return {components(s.force[node]), components(s.last_force[node]), components(s.velocity[node]), &scaling.mass[first],
            &scaling.inverse_mass[first]};
}

/// Mean motions of the clusters of a chunk, with x and y alternating.
struct Means {
    static constexpr std::int32_t size = 2 * clusters_per_chunk;
    alignas(64) double inverse_mass[size];
    alignas(64) double acceleration[size], change[size], velocity[size];  ///< change of the acceleration in a step
    alignas(64) double damping[size];                                     ///< damping force of the mean motion, per mass
    alignas(64) double relative[size];  ///< mean of the damping forces of the relative motion, per mass
};

/// Results for the nodes of a chunk, with x and y alternating.
struct NodeLanes {
    static constexpr std::int32_t size = 2 * nodes_per_chunk;
    alignas(64) double relative_damping[size];  ///< damping force of the relative motion before its mean is subtracted
    alignas(64) double new_velocity[size];
    alignas(64) double power[size];  ///< twice the power of damping, W
};

/// The rows of a chunk, as ranges of components counted from the first of the chunk.
struct Rows {
    const Range* rows;
    std::int32_t count, first_node;
    struct Row {
        std::int32_t begin, size;
    };
    GRAINCRACK_INLINE Row operator[](std::int32_t row) const {
        return {2 * (rows[row].begin - first_node), 2 * rows[row].size()};
    }
};
Rows rows_of(const Assemblage& a, const NodeChunk& chunk) {
    return {&a.rows[chunk.rows.begin], chunk.rows.size(), chunk.nodes.begin};
}

/// Adds the forces, their changes and the momenta of a row to those of the clusters.
GRAINCRACK_INLINE void add_motions(std::int32_t size, const double* force, const double* last_force, const double* mass,
                                   const double* velocity, double* __restrict sum_of_force, double* __restrict sum_of_change,
                                   double* __restrict momentum) {
    for (std::int32_t k = 0; k < size; ++k) {
        sum_of_force[k] += force[k];
        sum_of_change[k] += force[k] - last_force[k];
        momentum[k] += mass[k] * velocity[k];
    }
}

/// Computes the mean acceleration of clusters, its change in a step, and their mean velocity.
GRAINCRACK_INLINE void find_means(const Rows& rows, const Nodes& of_chunk, std::int32_t count, Means& means) {
    const Nodes nodes = of_chunk;  // a copy that no store can change
    for (std::int32_t k = 0; k < count; ++k) means.acceleration[k] = means.change[k] = means.velocity[k] = 0;
    for (std::int32_t row = 0; row < rows.count; ++row) {
        const auto [begin, size] = rows[row];
        add_motions(size, nodes.force + begin, nodes.last_force + begin, nodes.mass + begin, nodes.velocity + begin,
                    means.acceleration, means.change, means.velocity);
    }
    for (std::int32_t k = 0; k < count; ++k) {
        means.acceleration[k] *= means.inverse_mass[k];
        means.change[k] *= means.inverse_mass[k];
        means.velocity[k] *= means.inverse_mass[k];
    }
}

/// Computes the damping forces of the relative motion of the nodes of a row, and their sums over the clusters.
GRAINCRACK_INLINE void damp_relative_motion(std::int32_t size, const Damping& damping, const double* force,
                                            const double* last_force, const double* mass, const double* velocity,
                                            const Means& means, double* __restrict relative_damping, double* __restrict sum) {
    for (std::int32_t k = 0; k < size; ++k) {
        relative_damping[k] =
            damping_force(damping, force[k] - mass[k] * means.acceleration[k],
                          (force[k] - last_force[k]) - mass[k] * means.change[k], velocity[k] - means.velocity[k]);
        sum[k] += relative_damping[k];
    }
}

/// Computes the damping forces of the mean motions of clusters and of the relative motions of their nodes.
GRAINCRACK_INLINE void find_damping_forces(const Rows& rows, const Nodes& of_chunk, const Damping& shares, std::int32_t count,
                                           Means& means, NodeLanes& b) {
    const Nodes nodes = of_chunk;
    const Damping damping = shares;
    for (std::int32_t k = 0; k < count; ++k) means.relative[k] = 0;
    for (std::int32_t row = 0; row < rows.count; ++row) {
        const auto [begin, size] = rows[row];
        damp_relative_motion(size, damping, nodes.force + begin, nodes.last_force + begin, nodes.mass + begin,
                             nodes.velocity + begin, means, b.relative_damping + begin, means.relative);
    }
    for (std::int32_t k = 0; k < count; ++k) {
        means.damping[k] = damping_force(damping, means.acceleration[k], means.change[k], means.velocity[k]);
        means.relative[k] *= means.inverse_mass[k];
    }
}

/// The damping force on a component of a node, of the mean and of the relative motion.
GRAINCRACK_INLINE double whole_damping(const Means& means, std::int32_t k, double mass, double relative_damping) {
    return relative_damping + mass * (means.damping[k] - means.relative[k]);
}

void set_mean(double* values, std::int32_t cluster, const Vector2& mean) {
    values[2 * cluster] = mean.x;
    values[2 * cluster + 1] = mean.y;
}

/// Computes damping forces and mean motions of a chunk. Clusters that platens constrain have their motion, which is not damped.
void damp(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t index, const State& s,
          Means& means, NodeLanes& b) {
    const NodeChunk& chunk = a.node_chunks[index];
    const Rows rows = rows_of(a, chunk);
    const Nodes nodes = nodes_from(parameters.mass_scaling, chunk.nodes.begin, s);
    const std::int32_t count = 2 * chunk.clusters.size();
    for (std::int32_t cluster = 0; cluster < chunk.clusters.size(); ++cluster) {
        const double inverse_mass = s.clusters.inverse_mass[chunk.clusters.begin + cluster];
        set_mean(means.inverse_mass, cluster, {inverse_mass, inverse_mass});
    }
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { find_means(rows, nodes, count, means); });
    const PlatenVelocities platens(loading, parameters.time_step);
    for (const auto& [cluster, platen] : s.clusters.constrained[index]) {
        set_mean(means.velocity, cluster - chunk.clusters.begin, platens[platen]);
    }
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { find_damping_forces(rows, nodes, parameters.damps(), count, means, b); });
}

/// Computes the new velocities v + Δt M'⁻¹ (F + Fd) of a row, and the power of damping.
GRAINCRACK_INLINE void accelerate_row(std::int32_t size, const double* force, const double* mass, const double* inverse_mass,
                                      const double* velocity, const double* relative_damping, const Means& means, double own,
                                      double time_step, double* __restrict new_velocity, double* __restrict power) {
    for (std::int32_t k = 0; k < size; ++k) {
        const double damping = whole_damping(means, k, mass[k], relative_damping[k]);
        const double acceleration = (1 - own) * means.acceleration[k] + (own * inverse_mass[k]) * (force[k] + damping);
        new_velocity[k] = velocity[k] + time_step * acceleration;
        power[k] = damping * (velocity[k] + new_velocity[k]);
    }
}

/// Computes the new velocities of a chunk. \return twice the energy absorbed by damping over Δt, W
GRAINCRACK_INLINE double accelerate(const Rows& rows, const Nodes& of_chunk, double own, double time_step,
                                    std::int32_t n_components, const Means& means, NodeLanes& b) {
    const Nodes nodes = of_chunk;
    for (std::int32_t row = 0; row < rows.count; ++row) {
        const auto [begin, size] = rows[row];
        accelerate_row(size, nodes.force + begin, nodes.mass + begin, nodes.inverse_mass + begin, nodes.velocity + begin,
                       b.relative_damping + begin, means, own, time_step, b.new_velocity + begin, b.power + begin);
    }
    return -sum_values_by_lanes(n_components, b.power);
}

/// Stores the new velocities and the forces of the step, and moves the nodes: u += Δt v.
GRAINCRACK_INLINE void move(const double* force, const NodeLanes& b, double time_step, std::int32_t n_components,
                            double* __restrict last_force, double* __restrict velocity, double* __restrict displacement) {
    for (std::int32_t i = 0; i < n_components; ++i) {
        velocity[i] = b.new_velocity[i];
        displacement[i] += time_step * b.new_velocity[i];
        last_force[i] = force[i];
    }
}

/// Acceleration of the platen that constrains a cluster, along its axis, m/s².
double platen_acceleration(const StepLoading& loading, double time_step, std::uint8_t constraining_platen) {
    const std::size_t platen = constraining_platen - 1U;
    return (loading.increment_after[platen] - loading.increment_before[platen]) / (time_step * time_step);
}

/// Work of a platen on the added mass of a cluster that it constrains, J.
double platen_work(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, const NodeChunk& chunk,
                   const ConstrainedCluster& constrained, const State& s, const NodeLanes& b) {
    const double dt = parameters.time_step;
    const std::size_t platen = constrained.constraining_platen - 1U;
    const double acceleration = platen_acceleration(loading, dt, constrained.constraining_platen);
    double force = 0;
    for_each_node_of(a, chunk, constrained.cluster, [&](std::int32_t i) {
        const double* const new_velocity = &b.new_velocity[2 * (i - chunk.nodes.begin)];
        const Vector2 change = Vector2{new_velocity[0], new_velocity[1]} - s.velocity[i];
        force -= parameters.mass_scaling.factor * a.mass[i] * (dot(change, loading.platen_axis) / dt - acceleration);
    });
    return 0.5 * force * (loading.increment_before[platen] + loading.increment_after[platen]);
}

}  // namespace

void damp_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t index,
                   State& s) {
    Means means;
    NodeLanes b;
    damp(a, parameters, loading, index, s, means, b);
    const NodeChunk& chunk = a.node_chunks[index];
    for (std::int32_t i = chunk.nodes.begin; i < chunk.nodes.end; ++i) {
        const std::int32_t x = 2 * (i - chunk.nodes.begin);
        const std::int32_t mean_x = 2 * (a.cluster_of_node[i] - chunk.clusters.begin);
        s.damping_force[i] = {whole_damping(means, mean_x, a.mass[i], b.relative_damping[x]),
                              whole_damping(means, mean_x + 1, a.mass[i], b.relative_damping[x + 1])};
    }
}

void integrate_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t index,
                        State& s) {
    const NodeChunk& chunk = a.node_chunks[index];
    const double dt = parameters.time_step;
    Means means;
    NodeLanes b;
    damp(a, parameters, loading, index, s, means, b);
    for (std::int32_t k = 0; k < 2 * chunk.clusters.size(); ++k) means.acceleration[k] += means.damping[k];
    for (const auto& [cluster, platen] : s.clusters.constrained[index]) {
        set_mean(means.acceleration, cluster - chunk.clusters.begin,
                 platen_acceleration(loading, dt, platen) * loading.platen_axis);
    }
    const Rows rows = rows_of(a, chunk);
    const Nodes nodes = nodes_from(parameters.mass_scaling, chunk.nodes.begin, s);
    const std::int32_t n_components = 2 * chunk.nodes.size();
    double absorbed = 0;
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        absorbed = accelerate(rows, nodes, 1 / (1 + parameters.mass_scaling.factor), dt, n_components, means, b);
    });
    ClusterSums& sums = s.clusters.sums[index];
    sums.damping += 0.5 * dt * absorbed;
    for (const ConstrainedCluster& constrained : s.clusters.constrained[index]) {
        sums.platen_work += platen_work(a, parameters, loading, chunk, constrained, s, b);
    }
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        move(nodes.force, b, dt, n_components, components(s.last_force[chunk.nodes.begin]),
             components(s.velocity[chunk.nodes.begin]), components(s.displacement[chunk.nodes.begin]));
    });
}

}  // namespace graincrack
