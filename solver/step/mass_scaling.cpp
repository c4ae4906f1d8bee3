#include "solver/step/mass_scaling.hpp"

#include <algorithm>
#include <vector>

namespace graincrack {
namespace {

/// The mean velocity of the nodes of a cluster.
Vector2 mean_velocity(const Assemblage& a, const MassScaling& scaling, std::int32_t cluster, const State& s) {
    const Range nodes = scaling.clusters[cluster];
    Vector2 momentum;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const std::int32_t node = scaling.nodes[i];
        momentum += a.mass[node] * s.velocity[node];
    }
    return (1 / scaling.cluster_mass[cluster]) * momentum;
}

/// The velocity that the added mass moves with: the mean of the nodes, or that of the platen that constrains them.
Vector2 velocity_of_cluster(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens,
                            std::int32_t cluster, const State& s) {
    const std::uint8_t platen = s.clusters.constraining_platen[cluster];
    return platen != 0 ? platens[platen] : mean_velocity(a, scaling, cluster, s);
}

/// Kinetic energy ½ vᵀ(M' − M) v of a cluster, J.
double added_kinetic_energy_of(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens,
                               std::int32_t cluster, const State& s) {
    const Range nodes = scaling.clusters[cluster];
    const Vector2 mean = velocity_of_cluster(a, scaling, platens, cluster, s);
    double sum = 0;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const std::int32_t node = scaling.nodes[i];
        const Vector2 relative = s.velocity[node] - mean;
        sum += a.mass[node] * dot(relative, relative);
    }
    return 0.5 * scaling.factor * sum;
}

/// Kinetic energy of a cluster as the energy balance has it, up to what does not depend on velocities, J: ½ v(n−½)ᵀM' v(n+½) with
/// v(n+½) = v(n−½) + Δt M'⁻¹F.
double kinetic_energy_of(const Assemblage& a, const StepParameters& parameters, const PlatenVelocities& platens,
                         std::int32_t cluster, const State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    double sum = 0;
    for (std::int32_t i = scaling.clusters[cluster].begin; i < scaling.clusters[cluster].end; ++i) {
        const std::int32_t node = scaling.nodes[i];
        const Vector2& v = s.velocity[node];
        sum += a.mass[node] * dot(v, v) + parameters.time_step * dot(s.force[node], v);
    }
    return 0.5 * sum + added_kinetic_energy_of(a, scaling, platens, cluster, s);
}

/// The platen that a node of a cluster is near, 1 + its index; 0 for none.
std::uint8_t nearest_platen(const MassScaling& scaling, std::int32_t cluster, const ClusterState& g) {
    const Range nodes = scaling.clusters[cluster];
    return *std::max_element(g.near_platen.begin() + nodes.begin, g.near_platen.begin() + nodes.end);
}

void set_constraint(const MassScaling& scaling, std::int32_t cluster, ClusterState& g) {
    g.constraining_platen[cluster] = nearest_platen(scaling, cluster, g);
    g.inverse_mass[cluster] = g.constraining_platen[cluster] != 0 ? 0.0 : 1 / scaling.cluster_mass[cluster];
}

/// Lists the nodes of a chunk that platens constrain.
void find_constrained(const MassScaling& scaling, std::int32_t chunk, ClusterState& g) {
    const std::int32_t origin = scaling.nodes_of(chunk).begin;
    g.constrained[chunk].clear();
    for (std::int32_t cluster = scaling.chunks[chunk].begin; cluster < scaling.chunks[chunk].end; ++cluster) {
        const Range nodes = scaling.clusters[cluster];
        for (std::int32_t i = nodes.begin; i < nodes.end && g.constraining_platen[cluster] != 0; ++i) {
            g.constrained[chunk].push_back({i - origin, g.constraining_platen[cluster]});
        }
    }
}

/// A cluster meets or leaves a platen. If it leaves, its nodes keep their velocities; if it meets one, their momentum p = M' v:
/// with the mean u before and the platen's velocity V after, p/m = (1 + β) v − β u and v' = V + (p/m − V)/(1 + β). Neither
/// creates energy, relative to the platen.
void change_constraint(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, std::int32_t cluster,
                       State& s) {
    ClusterState& g = s.clusters;
    const Range nodes = scaling.clusters[cluster];
    const std::uint8_t old = g.constraining_platen[cluster];
    const Vector2 before = velocity_of_cluster(a, scaling, platens, cluster, s);
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        g.near_platen[i] = s.near_platen[scaling.nodes[i]];
    }
    set_constraint(scaling, cluster, g);
    const std::uint8_t now = g.constraining_platen[cluster];
    if (now == 0 || now == old) {
        return;
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        Vector2& v = s.velocity[scaling.nodes[i]];
        const Vector2 momentum = (1 + scaling.factor) * v - scaling.factor * before;
        v = platens[now] + (1 / (1 + scaling.factor)) * (momentum - platens[now]);
    }
}

/// Whether a node of a cluster has met or left a platen.
bool changes(const MassScaling& scaling, Range places, const State& s) {
    for (std::int32_t i = places.begin; i < places.end; ++i) {
        if (s.clusters.near_platen[i] != s.near_platen[scaling.nodes[i]]) {
            return true;
        }
    }
    return false;
}

/// Whether a cluster of a chunk may have changed.
bool may_change(const MassScaling& scaling, std::int32_t chunk, const State& s) {
    const std::vector<std::int32_t>& places = s.clusters.platen_nodes[chunk];
    return std::any_of(places.begin(), places.end(), [&](std::int32_t i) { return changes(scaling, {i, i + 1}, s); });
}

}  // namespace

ClusterState make_cluster_state(const MassScaling& scaling) {
    ClusterState g;
    g.near_platen.resize(scaling.nodes.size());
    g.sums.resize(scaling.chunks.size());
    return g;
}

void complete_cluster_state(const MassScaling& scaling, State& s) {
    ClusterState& g = s.clusters;
    s.contact_pairs.cluster_load.resize(scaling.clusters.size());
    g.near_platen.resize(scaling.nodes.size());
    g.constraining_platen.resize(scaling.clusters.size());
    g.inverse_mass.resize(scaling.clusters.size());
    for (std::int32_t cluster = 0; cluster < static_cast<std::int32_t>(scaling.clusters.size()); ++cluster) {
        set_constraint(scaling, cluster, g);
    }
    std::vector<bool> may_be_near(s.near_platen.size(), false);
    for (const PlatenPoint& point : s.platen_points) {
        may_be_near[point.node] = true;
    }
    g.platen_nodes.assign(scaling.chunks.size(), {});
    g.constrained.assign(scaling.chunks.size(), {});
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(scaling.chunks.size()); ++chunk) {
        find_constrained(scaling, chunk, g);
        const Range nodes = scaling.nodes_of(chunk);
        for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
            if (may_be_near[scaling.nodes[i]]) {
                g.platen_nodes[chunk].push_back(i);
            }
        }
    }
}

void update_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                     State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    if (!may_change(scaling, chunk, s)) {
        return;
    }
    const PlatenVelocities platens(loading, parameters.time_step);
    for (std::int32_t cluster = scaling.chunks[chunk].begin; cluster < scaling.chunks[chunk].end; ++cluster) {
        if (changes(scaling, scaling.clusters[cluster], s)) {
            const double before = kinetic_energy_of(a, parameters, platens, cluster, s);
            change_constraint(a, scaling, platens, cluster, s);
            s.clusters.sums[chunk].platen_loss += before - kinetic_energy_of(a, parameters, platens, cluster, s);
        }
    }
    find_constrained(scaling, chunk, s.clusters);
}

double added_kinetic_energy(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                            const State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const PlatenVelocities platens(loading, parameters.time_step);
    double sum = 0;
    for (std::int32_t cluster = scaling.chunks[chunk].begin; cluster < scaling.chunks[chunk].end; ++cluster) {
        sum += added_kinetic_energy_of(a, scaling, platens, cluster, s);
    }
    return sum;
}

}  // namespace graincrack
