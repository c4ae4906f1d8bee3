#include "solver/step/mass_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace graincrack {
namespace {

/// Whether a contact point links its nodes.
bool is_linking(const MassScaling::Link& link, const State& s) {
    return !s.points[link.point].separated || s.opening[link.point] < link.reach;
}

/// Lists the nodes of a chunk that platens constrain.
void find_constrained(const MassScaling& scaling, std::int32_t chunk, ClusterState& g) {
    const Range nodes = scaling.nodes_of(chunk);
    g.constrained[chunk].clear();
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        if (const std::uint8_t constraining_platen = g.constraining_platen[g.component[i]]; constraining_platen != 0) {
            g.constrained[chunk].push_back({i - nodes.begin, constraining_platen});
        }
    }
}

/// Finds the components of a cluster by its links, and whether a platen constrains them.
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

/// The mean velocity of the nodes with which node i is.
/// \param is_with (i, j): whether node j is one of them
/// \param platen the result if there are none: the velocity of the platen that constrains node i
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

/// Kinetic energy ½ vᵀM' v of a cluster, J, with the part ½ vᵀM v of the unscaled masses multiplied by `own`.
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

/// ½ Δt F·v of some nodes, J: the difference between ½ v(n−½)ᵀM' v(n−½) and the kinetic energy ½ v(n−½)ᵀM' v(n+½) of the energy
/// balance.
double half_impulse_work(const StepParameters& parameters, Range nodes, const State& s) {
    double sum = 0;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const std::int32_t node = parameters.mass_scaling.nodes[i];
        sum += dot(s.force[node], s.velocity[node]);
    }
    return 0.5 * parameters.time_step * sum;
}

/// Components of a cluster before it changes, by place.
struct OldComponents {
    Range places;
    std::vector<std::int32_t> component;
    std::vector<std::uint8_t> constraining_platen;

    OldComponents(const ClusterState& g, Range p)
        : places(p),
          component(g.component.begin() + p.begin, g.component.begin() + p.end),
          constraining_platen(g.constraining_platen.begin() + p.begin, g.constraining_platen.begin() + p.end) {}
    [[nodiscard]] std::int32_t component_of(std::int32_t i) const { return component[i - places.begin]; }
    [[nodiscard]] std::uint8_t platen_of(std::int32_t i) const { return constraining_platen[component_of(i) - places.begin]; }
};

/// Finds which links of a cluster hold now, and the components they make.
void relink(const Assemblage& a, const MassScaling& scaling, std::int32_t cluster, State& s) {
    ClusterState& g = s.clusters;
    const Range nodes = scaling.clusters[cluster];
    const Range links = scaling.links_of_cluster[cluster];
    for (std::int32_t t = links.begin; t < links.end; ++t) {
        g.linked[t] = is_linking(scaling.links[t], s) ? 1 : 0;
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        g.supported[i] = s.near_platen[scaling.nodes[i]];
    }
    find_components(a, scaling, cluster, g);
}

/// Sets the velocity of each node of a cluster to `velocity_of(i)`, which finds all of them before any is set.
template <class VelocityOf>
void set_velocities(const MassScaling& scaling, Range nodes, State& s, const VelocityOf& velocity_of) {
    std::vector<Vector2> velocities;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        velocities.push_back(velocity_of(i));
    }
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        s.velocity[scaling.nodes[i]] = velocities[i - nodes.begin];
    }
}

/// Changes the components of a cluster: nodes that split keep their velocities, nodes that join their momentum. Neither creates
/// energy, relative to the platen where one constrains them.
void change_cluster(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, std::int32_t cluster,
                    State& s) {
    const ClusterState& g = s.clusters;
    const Range nodes = scaling.clusters[cluster];
    const OldComponents old(g, nodes);
    relink(a, scaling, cluster, s);
    const auto platen_now = [&](std::int32_t i) { return g.constraining_platen[g.component[i]]; };
    // First all nodes split that will: momentum over mass, p = M' v of what remains linked. Then those that are linked share it,
    // v = M'⁻¹ p.
    set_velocities(scaling, nodes, s, [&](std::int32_t i) {
        const Vector2 mean =
            mean_velocity(a, scaling, nodes, i, s, platens[old.platen_of(i)], [&](std::int32_t k, std::int32_t j) {
                return old.component_of(j) == old.component_of(k) && g.component[j] == g.component[k] &&
                       !(old.platen_of(k) != 0 && platen_now(k) != 0);
            });
        return (1 + scaling.factor) * s.velocity[scaling.nodes[i]] - scaling.factor * mean;
    });
    set_velocities(scaling, nodes, s, [&](std::int32_t i) {
        const Vector2 mean = mean_velocity(a, scaling, nodes, i, s, platens[platen_now(i)], [&](std::int32_t k, std::int32_t j) {
            return g.component[j] == g.component[k] && platen_now(k) == 0;
        });
        const Vector2 own = s.velocity[scaling.nodes[i]];
        return mean + (1 / (1 + scaling.factor)) * (own - mean);
    });
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
        g.linked.push_back(is_linking(link, s) ? 1 : 0);
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

/// Whether a cluster of a chunk may have changed: a point of it has failed, or a node has met or left a platen.
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
            changes = changes || (s.failed[scaling.links[t].point] != 0 && is_linking(scaling.links[t], s) != (g.linked[t] != 0));
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
