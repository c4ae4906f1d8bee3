#include "solver/step/mass_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace graincrack {
namespace {

bool holds(const MassScaling::Link& link, const State& s) {
    return !s.points[link.point].separated || s.opening[link.point] < link.reach;
}

/// Lists the nodes of a chunk that platens hold.
void find_constrained(const MassScaling& scaling, std::int32_t chunk, ClusterState& g) {
    const Range nodes = scaling.nodes_of(chunk);
    g.constrained[chunk].clear();
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        if (const std::uint8_t constraining_platen = g.constraining_platen[g.component[i]]; constraining_platen != 0) {
            g.constrained[chunk].push_back({i - nodes.begin, constraining_platen});
        }
    }
}

/// Finds the components of a cluster by its ties, and whether a platen holds them.
void find_components(const Assemblage& a, const MassScaling& scaling, std::int32_t cluster, ClusterState& g) {
    const Range nodes = scaling.clusters[cluster];
    const Range links = scaling.links_of_cluster[cluster];
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        g.component[i] = i;
        g.inverse_mass[i] = 0;
        g.constraining_platen[i] = 0;
    }
    for (std::int32_t t = links.begin; t < links.end; ++t) {
        if (g.linked[t] != 0) {
            const std::int32_t i = root_of(g.component, scaling.links[t].first);
            const std::int32_t j = root_of(g.component, scaling.links[t].second);
            g.component[std::max(i, j)] = std::min(i, j);
        }
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        g.component[i] = root_of(g.component, i);
        g.inverse_mass[g.component[i]] += a.mass[scaling.nodes[i]];
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        g.inverse_mass[i] = g.inverse_mass[i] > 0 ? 1 / g.inverse_mass[i] : 0.0;
    }
    g.whole[cluster] = 1;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        if (g.supported[i] != 0) {
            g.inverse_mass[g.component[i]] = 0;
            g.constraining_platen[g.component[i]] = g.supported[i];
        }
        if (g.component[i] != nodes.begin) {
            g.whole[cluster] = 0;
        }
    }
}

/// The mean velocity of those a node is held together with.
/// \param is_with (i, j): nodes i and j are held together
/// \param platen what it is if there are none: the velocity of the platen that holds it
template <class IsWith>
Vector2 mean_velocity(const Assemblage& a, const MassScaling& scaling, Range nodes, std::int32_t i, const State& s,
                      const Vector2& platen, IsWith&& is_with) {
    Vector2 momentum;
    double mass = 0;
    for (std::int32_t j = nodes.begin; j < nodes.end; ++j) {
        if (is_with(i, j)) {
            const std::int32_t node = scaling.nodes[j];
            momentum += a.mass[node] * s.velocity[node];
            mass += a.mass[node];
        }
    }
    return mass > 0 ? (1 / mass) * momentum : platen;
}

/// Kinetic energy ½ vᵀM' v of a cluster, J, with `own` times that of its masses as they are.
double kinetic_energy(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, std::int32_t cluster,
                      const State& s, double own) {
    const Range nodes = scaling.clusters[cluster];
    const ClusterState& g = s.clusters;
    double sum = 0;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const std::int32_t node = scaling.nodes[i];
        const std::uint8_t constraining_platen = g.constraining_platen[g.component[i]];
        const Vector2 mean = mean_velocity(
            a, scaling, nodes, i, s, platens[constraining_platen],
            [&](std::int32_t k, std::int32_t j) { return g.component[j] == g.component[k] && constraining_platen == 0; });
        const Vector2 relative = s.velocity[node] - mean;
        sum += a.mass[node] * (own * dot(s.velocity[node], s.velocity[node]) + scaling.factor * dot(relative, relative));
    }
    return 0.5 * sum;
}

/// ½ Δt F·v of some nodes, J: what is between ½ v(n−½)ᵀM' v(n−½) and the energy ½ v(n−½)ᵀM' v(n+½) of the ledger.
double half_impulse_work(const StepParameters& parameters, Range nodes, const State& s) {
    double sum = 0;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const std::int32_t node = parameters.mass_scaling.nodes[i];
        sum += dot(s.force[node], s.velocity[node]);
    }
    return 0.5 * parameters.time_step * sum;
}

/// Gives those that part their velocities and those that meet their momentum: neither makes energy, seen from the platen where
/// one holds them.
void change_cluster(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, std::int32_t cluster,
                    State& s) {
    ClusterState& g = s.clusters;
    const Range nodes = scaling.clusters[cluster];
    const Range links = scaling.links_of_cluster[cluster];
    const auto of_cluster = [&nodes](const auto& all) { return std::vector(all.begin() + nodes.begin, all.begin() + nodes.end); };
    const std::vector<std::int32_t> old_component = of_cluster(g.component);
    const std::vector<std::uint8_t> old_platen = of_cluster(g.constraining_platen);
    for (std::int32_t t = links.begin; t < links.end; ++t) {
        g.linked[t] = holds(scaling.links[t], s) ? 1 : 0;
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        g.supported[i] = s.near_platen[scaling.nodes[i]];
    }
    find_components(a, scaling, cluster, g);
    // First all part that will, with p = M' v of what is left; then those held together anew share it, v = M'⁻¹ p.
    const auto platen_before = [&](std::int32_t i) { return old_platen[old_component[i - nodes.begin] - nodes.begin]; };
    const auto platen_now = [&](std::int32_t i) { return g.constraining_platen[g.component[i]]; };
    std::vector<Vector2> specific_momentum;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const Vector2 mean =
            mean_velocity(a, scaling, nodes, i, s, platens[platen_before(i)], [&](std::int32_t k, std::int32_t j) {
                return old_component[j - nodes.begin] == old_component[k - nodes.begin] && g.component[j] == g.component[k] &&
                       !(platen_before(k) != 0 && platen_now(k) != 0);
            });
        specific_momentum.push_back((1 + scaling.factor) * s.velocity[scaling.nodes[i]] - scaling.factor * mean);
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        s.velocity[scaling.nodes[i]] = specific_momentum[i - nodes.begin];
    }
    std::vector<Vector2> velocity;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const Vector2 mean = mean_velocity(a, scaling, nodes, i, s, platens[platen_now(i)], [&](std::int32_t k, std::int32_t j) {
            return g.component[j] == g.component[k] && platen_now(k) == 0;
        });
        const Vector2 own = s.velocity[scaling.nodes[i]];
        velocity.push_back(mean + (1 / (1 + scaling.factor)) * (own - mean));
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        s.velocity[scaling.nodes[i]] = velocity[i - nodes.begin];
    }
}

}  // namespace

ClusterState make_cluster_state(const Assemblage& a, const MassScaling& scaling, const State& s) {
    ClusterState g;
    g.component.resize(scaling.nodes.size());
    g.inverse_mass.resize(scaling.nodes.size());
    g.constraining_platen.resize(scaling.nodes.size());
    g.whole.resize(scaling.clusters.size());
    g.sums.resize(scaling.chunks.size());
    for (const MassScaling::Link& link : scaling.links) {
        g.linked.push_back(holds(link, s) ? 1 : 0);
    }
    g.supported.resize(scaling.nodes.size());
    for (std::int32_t cluster = 0; cluster < static_cast<std::int32_t>(scaling.clusters.size()); ++cluster) {
        find_components(a, scaling, cluster, g);
    }
    return g;
}

void complete_cluster_state(const MassScaling& scaling, State& s) {
    ClusterState& g = s.clusters;
    std::vector<bool> may_be_near(s.near_platen.size(), false);
    for (const PlatenPoint& point : s.platen_points) {
        may_be_near[point.node] = true;
    }
    g.constraining_platen.assign(scaling.nodes.size(), 0);
    for (std::size_t i = 0; i < scaling.nodes.size(); ++i) {
        std::uint8_t& constraining_platen = g.constraining_platen[g.component[i]];
        constraining_platen = std::max(constraining_platen, g.supported[i]);
    }
    g.whole.assign(scaling.clusters.size(), 1);
    g.cracked.assign(scaling.chunks.size(), 0);
    g.platen_nodes.assign(scaling.chunks.size(), {});
    g.constrained.resize(scaling.chunks.size());
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(scaling.chunks.size()); ++chunk) {
        find_constrained(scaling, chunk, g);
        const Range clusters = scaling.chunks[chunk];
        for (std::int32_t cluster = clusters.begin; cluster < clusters.end; ++cluster) {
            for (std::int32_t i = scaling.clusters[cluster].begin; i < scaling.clusters[cluster].end; ++i) {
                if (g.component[i] != scaling.clusters[cluster].begin) {
                    g.whole[cluster] = 0;
                }
                if (may_be_near[scaling.nodes[i]]) {
                    g.platen_nodes[chunk].push_back(i);
                }
            }
        }
    }
    g.chunk_of_point.resize(scaling.links.size());
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(scaling.chunks.size()); ++chunk) {
        const Range clusters = scaling.chunks[chunk];
        for (std::int32_t t = scaling.links_of_cluster[clusters.begin].begin; t < scaling.links_of_cluster[clusters.end - 1].end;
             ++t) {
            g.chunk_of_point[scaling.links[t].point] = chunk;
            g.cracked[chunk] |= s.failed[scaling.links[t].point];
        }
    }
}

namespace {

/// Whether a cluster of a chunk may have changed: a point of it has failed, or a platen has come or gone.
bool may_change(const MassScaling& scaling, std::int32_t chunk, const State& s) {
    const ClusterState& g = s.clusters;
    return g.cracked[chunk] != 0 || std::any_of(g.platen_nodes[chunk].begin(), g.platen_nodes[chunk].end(), [&](std::int32_t i) {
               return g.supported[i] != s.near_platen[scaling.nodes[i]];
           });
}

}  // namespace

void update_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                     State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    ClusterState& g = s.clusters;
    if (!may_change(scaling, chunk, s)) {
        return;
    }
    const PlatenVelocities platens(loading, parameters.time_step);
    for (std::int32_t cluster = scaling.chunks[chunk].begin; cluster < scaling.chunks[chunk].end; ++cluster) {
        const Range links = scaling.links_of_cluster[cluster];
        const Range nodes = scaling.clusters[cluster];
        bool changes = false;
        for (std::int32_t t = links.begin; t < links.end; ++t) {
            changes = changes || (s.failed[scaling.links[t].point] != 0 && holds(scaling.links[t], s) != (g.linked[t] != 0));
        }
        for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
            changes = changes || g.supported[i] != s.near_platen[scaling.nodes[i]];
        }
        if (!changes) {
            continue;
        }
        const auto energy = [&] {
            return kinetic_energy(a, scaling, platens, cluster, s, 1) + half_impulse_work(parameters, nodes, s);
        };
        const double before = energy();
        change_cluster(a, scaling, platens, cluster, s);
        g.sums[chunk].regrouping_loss += before - energy();
        find_constrained(scaling, chunk, g);
    }
}

void drop_added_mass(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, double time_step,
                     State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const double shorter = 1 - time_step / parameters.time_step;
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(scaling.chunks.size()); ++chunk) {
        s.clusters.sums[chunk].regrouping_loss += added_kinetic_energy(a, parameters, loading, chunk, s) +
                                                  shorter * half_impulse_work(parameters, scaling.nodes_of(chunk), s);
    }
}

double added_kinetic_energy(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                            const State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const PlatenVelocities platens(loading, parameters.time_step);
    double sum = 0;
    for (std::int32_t cluster = scaling.chunks[chunk].begin; cluster < scaling.chunks[chunk].end; ++cluster) {
        sum += kinetic_energy(a, scaling, platens, cluster, s, 0);
    }
    return sum;
}

}  // namespace graincrack
