#include "solver/step/mass_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace graincrack {
namespace {

bool holds(const MassScaling::Link& tie, const State& s) {
    return !s.points[tie.point].separated || s.opening[tie.point] < tie.reach;
}

/// Lists the members of a block that platens hold.
void find_constrained(const MassScaling& scaling, std::int32_t block, ClusterState& g) {
    const Range members = scaling.members_of(block);
    g.constrained[block].clear();
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        if (const std::uint8_t constraining_platen = g.constraining_platen[g.component[i]]; constraining_platen != 0) {
            g.constrained[block].push_back({i - members.begin, constraining_platen});
        }
    }
}

/// Finds the components of a group by its ties, and whether a platen holds them.
void find_components(const Assemblage& a, const MassScaling& scaling, std::int32_t group, ClusterState& g) {
    const Range members = scaling.groups[group];
    const Range links = scaling.links_of_group[group];
    for (std::int32_t i = members.begin; i < members.end; ++i) {
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
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        g.component[i] = root_of(g.component, i);
        g.inverse_mass[g.component[i]] += a.mass[scaling.members[i]];
    }
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        g.inverse_mass[i] = g.inverse_mass[i] > 0 ? 1 / g.inverse_mass[i] : 0.0;
    }
    g.whole[group] = 1;
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        if (g.supported[i] != 0) {
            g.inverse_mass[g.component[i]] = 0;
            g.constraining_platen[g.component[i]] = g.supported[i];
        }
        if (g.component[i] != members.begin) {
            g.whole[group] = 0;
        }
    }
}

/// The mean velocity of those a member is held together with.
/// \param is_with (i, j): members i and j are held together
/// \param platen what it is if there are none: the velocity of the platen that holds it
template <class IsWith>
Vector2 mean_velocity(const Assemblage& a, const MassScaling& scaling, Range members, std::int32_t i, const State& s,
                      const Vector2& platen, IsWith&& is_with) {
    Vector2 momentum;
    double mass = 0;
    for (std::int32_t j = members.begin; j < members.end; ++j) {
        if (is_with(i, j)) {
            const std::int32_t node = scaling.members[j];
            momentum += a.mass[node] * s.velocity[node];
            mass += a.mass[node];
        }
    }
    return mass > 0 ? (1 / mass) * momentum : platen;
}

/// Kinetic energy ½ vᵀM' v of a group, J, with `own` times that of its masses as they are.
double kinetic_energy(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, std::int32_t group,
                      const State& s, double own) {
    const Range members = scaling.groups[group];
    const ClusterState& g = s.clusters;
    double sum = 0;
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        const std::int32_t node = scaling.members[i];
        const std::uint8_t constraining_platen = g.constraining_platen[g.component[i]];
        const Vector2 mean = mean_velocity(
            a, scaling, members, i, s, platens[constraining_platen],
            [&](std::int32_t k, std::int32_t j) { return g.component[j] == g.component[k] && constraining_platen == 0; });
        const Vector2 relative = s.velocity[node] - mean;
        sum += a.mass[node] * (own * dot(s.velocity[node], s.velocity[node]) + scaling.factor * dot(relative, relative));
    }
    return 0.5 * sum;
}

/// ½ Δt F·v of some members, J: what is between ½ v(n−½)ᵀM' v(n−½) and the energy ½ v(n−½)ᵀM' v(n+½) of the ledger.
double half_impulse_work(const StepParameters& parameters, Range members, const State& s) {
    double sum = 0;
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        const std::int32_t node = parameters.mass_scaling.members[i];
        sum += dot(s.force[node], s.velocity[node]);
    }
    return 0.5 * parameters.time_step * sum;
}

/// Gives those that part their velocities and those that meet their momentum: neither makes energy, seen from the platen where
/// one holds them.
void change_cluster(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, std::int32_t group,
                    State& s) {
    ClusterState& g = s.clusters;
    const Range members = scaling.groups[group];
    const Range links = scaling.links_of_group[group];
    const auto of_group = [&members](const auto& all) {
        return std::vector(all.begin() + members.begin, all.begin() + members.end);
    };
    const std::vector<std::int32_t> old_component = of_group(g.component);
    const std::vector<std::uint8_t> old_holder = of_group(g.constraining_platen);
    for (std::int32_t t = links.begin; t < links.end; ++t) {
        g.linked[t] = holds(scaling.links[t], s) ? 1 : 0;
    }
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        g.supported[i] = s.touching[scaling.members[i]];
    }
    find_components(a, scaling, group, g);
    // First all part that will, with p = M' v of what is left; then those held together anew share it, v = M'⁻¹ p.
    const auto held_by = [&](std::int32_t i) { return old_holder[old_component[i - members.begin] - members.begin]; };
    const auto holder_now = [&](std::int32_t i) { return g.constraining_platen[g.component[i]]; };
    std::vector<Vector2> specific_momentum;
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        const Vector2 mean = mean_velocity(a, scaling, members, i, s, platens[held_by(i)], [&](std::int32_t k, std::int32_t j) {
            return old_component[j - members.begin] == old_component[k - members.begin] && g.component[j] == g.component[k] &&
                   !(held_by(k) != 0 && holder_now(k) != 0);
        });
        specific_momentum.push_back((1 + scaling.factor) * s.velocity[scaling.members[i]] - scaling.factor * mean);
    }
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        s.velocity[scaling.members[i]] = specific_momentum[i - members.begin];
    }
    std::vector<Vector2> velocity;
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        const Vector2 mean =
            mean_velocity(a, scaling, members, i, s, platens[holder_now(i)],
                          [&](std::int32_t k, std::int32_t j) { return g.component[j] == g.component[k] && holder_now(k) == 0; });
        const Vector2 own = s.velocity[scaling.members[i]];
        velocity.push_back(mean + (1 / (1 + scaling.factor)) * (own - mean));
    }
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        s.velocity[scaling.members[i]] = velocity[i - members.begin];
    }
}

}  // namespace

ClusterState make_cluster_state(const Assemblage& a, const MassScaling& scaling, const State& s) {
    ClusterState g;
    g.component.resize(scaling.members.size());
    g.inverse_mass.resize(scaling.members.size());
    g.constraining_platen.resize(scaling.members.size());
    g.whole.resize(scaling.groups.size());
    g.sums.resize(scaling.blocks.size());
    for (const MassScaling::Link& tie : scaling.links) {
        g.linked.push_back(holds(tie, s) ? 1 : 0);
    }
    g.supported.resize(scaling.members.size());
    for (std::int32_t group = 0; group < static_cast<std::int32_t>(scaling.groups.size()); ++group) {
        find_components(a, scaling, group, g);
    }
    return g;
}

void complete_cluster_state(const MassScaling& scaling, State& s) {
    ClusterState& g = s.clusters;
    std::vector<bool> may_touch(s.touching.size(), false);
    for (const PlatenPoint& point : s.platen_points) {
        may_touch[point.node] = true;
    }
    g.constraining_platen.assign(scaling.members.size(), 0);
    for (std::size_t i = 0; i < scaling.members.size(); ++i) {
        std::uint8_t& constraining_platen = g.constraining_platen[g.component[i]];
        constraining_platen = std::max(constraining_platen, g.supported[i]);
    }
    g.whole.assign(scaling.groups.size(), 1);
    g.cracked.assign(scaling.blocks.size(), 0);
    g.platen_members.assign(scaling.blocks.size(), {});
    g.constrained.resize(scaling.blocks.size());
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(scaling.blocks.size()); ++block) {
        find_constrained(scaling, block, g);
        const Range groups = scaling.blocks[block];
        for (std::int32_t group = groups.begin; group < groups.end; ++group) {
            for (std::int32_t i = scaling.groups[group].begin; i < scaling.groups[group].end; ++i) {
                if (g.component[i] != scaling.groups[group].begin) {
                    g.whole[group] = 0;
                }
                if (may_touch[scaling.members[i]]) {
                    g.platen_members[block].push_back(i);
                }
            }
        }
    }
    g.block_of_point.resize(scaling.links.size());
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(scaling.blocks.size()); ++block) {
        const Range groups = scaling.blocks[block];
        for (std::int32_t t = scaling.links_of_group[groups.begin].begin; t < scaling.links_of_group[groups.end - 1].end; ++t) {
            g.block_of_point[scaling.links[t].point] = block;
            g.cracked[block] |= s.failed[scaling.links[t].point];
        }
    }
}

namespace {

/// Whether a group of a block may have changed: a point of it has failed, or a platen has come or gone.
bool may_change(const MassScaling& scaling, std::int32_t block, const State& s) {
    const ClusterState& g = s.clusters;
    return g.cracked[block] != 0 || std::any_of(g.platen_members[block].begin(), g.platen_members[block].end(),
                                                [&](std::int32_t i) { return g.supported[i] != s.touching[scaling.members[i]]; });
}

}  // namespace

void update_clusters(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t block,
                     State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    ClusterState& g = s.clusters;
    if (!may_change(scaling, block, s)) {
        return;
    }
    const PlatenVelocities platens(loading, parameters.time_step);
    for (std::int32_t group = scaling.blocks[block].begin; group < scaling.blocks[block].end; ++group) {
        const Range links = scaling.links_of_group[group];
        const Range members = scaling.groups[group];
        bool changes = false;
        for (std::int32_t t = links.begin; t < links.end; ++t) {
            changes = changes || (s.failed[scaling.links[t].point] != 0 && holds(scaling.links[t], s) != (g.linked[t] != 0));
        }
        for (std::int32_t i = members.begin; i < members.end; ++i) {
            changes = changes || g.supported[i] != s.touching[scaling.members[i]];
        }
        if (!changes) {
            continue;
        }
        const auto energy = [&] {
            return kinetic_energy(a, scaling, platens, group, s, 1) + half_impulse_work(parameters, members, s);
        };
        const double before = energy();
        change_cluster(a, scaling, platens, group, s);
        g.sums[block].regrouping_loss += before - energy();
        find_constrained(scaling, block, g);
    }
}

void drop_added_mass(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, double time_step,
                     State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const double shorter = 1 - time_step / parameters.time_step;
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(scaling.blocks.size()); ++block) {
        s.clusters.sums[block].regrouping_loss += added_kinetic_energy(a, parameters, loading, block, s) +
                                                  shorter * half_impulse_work(parameters, scaling.members_of(block), s);
    }
}

double added_kinetic_energy(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t block,
                            const State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const PlatenVelocities platens(loading, parameters.time_step);
    double sum = 0;
    for (std::int32_t group = scaling.blocks[block].begin; group < scaling.blocks[block].end; ++group) {
        sum += kinetic_energy(a, scaling, platens, group, s, 0);
    }
    return sum;
}

}  // namespace graincrack
