#include "solver/step/mass_scaling.hpp"

#include <algorithm>
#include <vector>

namespace graincrack {
namespace {

/// Σ `of_node(i)` over the nodes of a cluster of a chunk.
template <class OfNode>
auto sum_over_cluster(const Assemblage& a, const NodeChunk& chunk, std::int32_t cluster, const OfNode& of_node) {
    decltype(of_node(0)) sum{};
    for_each_node_of(a, chunk, cluster, [&](std::int32_t i) { sum += of_node(i); });
    return sum;
}

/// Velocity of the added mass: the mean of the nodes, or that of the platen that constrains them, m/s.
Vector2 velocity_of_cluster(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens,
                            const NodeChunk& chunk, std::int32_t cluster, const State& s) {
    if (const std::uint8_t platen = s.clusters.constraining_platen[cluster]; platen != 0) return platens[platen];
    const Vector2 momentum = sum_over_cluster(a, chunk, cluster, [&](std::int32_t i) { return a.mass[i] * s.velocity[i]; });
    return (1 / scaling.cluster_mass[cluster]) * momentum;
}

/// Kinetic energy ½ vᵀ(M' − M) v of a cluster, J.
double added_kinetic_energy_of(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens,
                               const NodeChunk& chunk, std::int32_t cluster, const State& s) {
    const Vector2 mean = velocity_of_cluster(a, scaling, platens, chunk, cluster, s);
    return 0.5 * scaling.factor * sum_over_cluster(a, chunk, cluster, [&](std::int32_t i) {
               const Vector2 relative = s.velocity[i] - mean;
               return a.mass[i] * dot(relative, relative);
           });
}

/// Kinetic energy of a cluster in the energy balance, J, up to a part that does not depend on velocities: ½ v(n−½)ᵀM' v(n+½) with
/// v(n+½) = v(n−½) + Δt M'⁻¹F.
double kinetic_energy_of(const Assemblage& a, const StepParameters& parameters, const PlatenVelocities& platens,
                         const NodeChunk& chunk, std::int32_t cluster, const State& s) {
    const double own = 0.5 * sum_over_cluster(a, chunk, cluster, [&](std::int32_t i) {
                           const Vector2& v = s.velocity[i];
                           return a.mass[i] * dot(v, v) + parameters.time_step * dot(s.force[i], v);
                       });
    return own + added_kinetic_energy_of(a, parameters.mass_scaling, platens, chunk, cluster, s);
}

/// Finds the platen that constrains a cluster from the platens near its nodes.
void set_constraint(const Assemblage& a, const MassScaling& scaling, const NodeChunk& chunk, std::int32_t cluster,
                    ClusterState& g) {
    std::uint8_t platen = 0;
    for_each_node_of(a, chunk, cluster, [&](std::int32_t i) { platen = std::max(platen, g.near_platen[i]); });
    g.constraining_platen[cluster] = platen;
    g.inverse_mass[cluster] = platen != 0 ? 0.0 : 1 / scaling.cluster_mass[cluster];
}

/// Lists the clusters of a chunk that platens constrain.
void find_constrained(const Range& clusters, std::vector<ConstrainedCluster>& constrained, const ClusterState& g) {
    constrained.clear();
    for (std::int32_t cluster = clusters.begin; cluster < clusters.end; ++cluster) {
        if (g.constraining_platen[cluster] != 0) constrained.push_back({cluster, g.constraining_platen[cluster]});
    }
}

/// Updates a cluster that meets or leaves a platen. If it leaves, its nodes keep their velocities; if it meets one, they keep
/// their momentum p = M' v: with their mean velocity u before and the platen's velocity V after it, p/m = (1 + β) v − β u and v'
/// = V + (p/m − V)/(1 + β). Neither creates energy relative to the platen.
void change_constraint(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, const NodeChunk& chunk,
                       std::int32_t cluster, State& s) {
    ClusterState& g = s.clusters;
    const std::uint8_t old = g.constraining_platen[cluster];
    const Vector2 before = velocity_of_cluster(a, scaling, platens, chunk, cluster, s);
    for_each_node_of(a, chunk, cluster, [&](std::int32_t i) { g.near_platen[i] = s.near_platen[i]; });
    set_constraint(a, scaling, chunk, cluster, g);
    const std::uint8_t now = g.constraining_platen[cluster];
    if (now == 0 || now == old) return;
    for_each_node_of(a, chunk, cluster, [&](std::int32_t i) {
        Vector2& v = s.velocity[i];
        const Vector2 momentum = (1 + scaling.factor) * v - scaling.factor * before;
        v = platens[now] + (1 / (1 + scaling.factor)) * (momentum - platens[now]);
    });
}

/// True if a node has met or left a platen.
bool changes(std::int32_t node, const State& s) { return s.clusters.near_platen[node] != s.near_platen[node]; }

}  // namespace

void complete_cluster_state(const Assemblage& a, const MassScaling& scaling, State& s) {
    if (!scaling.is_on()) return;
    ClusterState& g = s.clusters;
    s.contact_pairs.cluster_load.resize(a.n_clusters());
    g.near_platen.resize(a.n_nodes());
    g.sums.resize(a.node_chunks.size());
    g.constraining_platen.resize(a.n_clusters());
    g.inverse_mass.resize(a.n_clusters());
    std::vector<bool> may_be_near(a.n_nodes(), false);
    for (const PlatenPoint& point : s.platen_points) may_be_near[point.node] = true;
    g.platen_nodes.assign(a.node_chunks.size(), {});
    g.constrained.assign(a.node_chunks.size(), {});
    for (std::size_t index = 0; index < a.node_chunks.size(); ++index) {
        const NodeChunk& chunk = a.node_chunks[index];
        for (std::int32_t cluster = chunk.clusters.begin; cluster < chunk.clusters.end; ++cluster) {
            set_constraint(a, scaling, chunk, cluster, g);
        }
        find_constrained(chunk.clusters, g.constrained[index], g);
        for (std::int32_t i = chunk.nodes.begin; i < chunk.nodes.end; ++i) {
            if (may_be_near[i]) g.platen_nodes[index].push_back(i);
        }
    }
}

void update_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t index,
                     State& s) {
    const std::vector<std::int32_t>& platen_nodes = s.clusters.platen_nodes[index];
    if (std::none_of(platen_nodes.begin(), platen_nodes.end(), [&](std::int32_t i) { return changes(i, s); })) return;
    const NodeChunk& chunk = a.node_chunks[index];
    const PlatenVelocities platens(loading, parameters.time_step);
    for (std::int32_t cluster = chunk.clusters.begin; cluster < chunk.clusters.end; ++cluster) {
        bool has_changed = false;
        for_each_node_of(a, chunk, cluster, [&](std::int32_t i) { has_changed = has_changed || changes(i, s); });
        if (has_changed) {
            const double before = kinetic_energy_of(a, parameters, platens, chunk, cluster, s);
            change_constraint(a, parameters.mass_scaling, platens, chunk, cluster, s);
            s.clusters.sums[index].platen_loss += before - kinetic_energy_of(a, parameters, platens, chunk, cluster, s);
        }
    }
    find_constrained(chunk.clusters, s.clusters.constrained[index], s.clusters);
}

double added_kinetic_energy(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t index,
                            const State& s) {
    const NodeChunk& chunk = a.node_chunks[index];
    const PlatenVelocities platens(loading, parameters.time_step);
    return sum_over(chunk.clusters, [&](std::int32_t cluster) {
        return added_kinetic_energy_of(a, parameters.mass_scaling, platens, chunk, cluster, s);
    });
}

}  // namespace graincrack
