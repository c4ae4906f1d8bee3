#include "solver/mass_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "share/error.hpp"
#include "solver/state.hpp"
#include "solver/step.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t groups_per_block = 32;
constexpr std::int32_t lanes = 8;  // of the widest vector unit
static_assert(2 * members_per_block % lanes == 0);

/// Representative of `i` in a forest of parents, with the way there shortened.
std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

/// The lowest node that each node shares a vertex with.
std::vector<std::int32_t> vertex_of_nodes(const Assemblage& a) {
    std::vector<std::int32_t> parent(a.position.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const ContactGeometry& g : a.contacts) {
        for (std::size_t p = 0; p < 2; ++p) {
            const std::int32_t i = root_of(parent, g.nodes[p]);
            const std::int32_t j = root_of(parent, g.nodes[2 + p]);
            parent[std::max(i, j)] = std::min(i, j);
        }
    }
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        parent[i] = root_of(parent, i);
    }
    return parent;
}

/// Cuts a sequence sorted by group into one range a group.
template <class GroupOf>
std::vector<Range> ranges_of_groups(std::int32_t count, std::int32_t n_groups, GroupOf&& group_of) {
    std::vector<Range> ranges(n_groups);
    std::int32_t i = 0;
    for (std::int32_t g = 0; g < n_groups; ++g) {
        ranges[g].begin = i;
        while (i < count && group_of(i) == g) {
            ++i;
        }
        ranges[g].end = i;
    }
    return ranges;
}

bool holds(const MassScaling::Tie& tie, const State& s) {
    return !s.points[tie.point].separated || s.opening[tie.point] < tie.reach;
}

/// Finds the components of a group by its ties, and whether a platen holds them.
void find_components(const Assemblage& a, const MassScaling& scaling, std::int32_t group, GroupState& g) {
    const Range members = scaling.groups[group];
    const Range ties = scaling.ties_of_group[group];
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        g.component[i] = i;
        g.inverse_mass[i] = 0;
        g.holder[i] = 0;
    }
    for (std::int32_t t = ties.begin; t < ties.end; ++t) {
        if (g.tied[t] != 0) {
            const std::int32_t i = root_of(g.component, scaling.ties[t].first);
            const std::int32_t j = root_of(g.component, scaling.ties[t].second);
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
            g.holder[g.component[i]] = g.supported[i];
        }
        if (g.component[i] != members.begin) {
            g.whole[group] = 0;
        }
    }
}

/// Velocities of the platens, by `GroupState::holder`.
class PlatenVelocities {
public:
    /// As node velocities: half a step before now.
    PlatenVelocities(const StepLoading& loading, double time_step)
        : velocity_{Vector2{}, {0, loading.increment_before[0] / time_step}, {0, loading.increment_before[1] / time_step}} {}
    [[nodiscard]] const Vector2& operator[](std::uint8_t holder) const { return velocity_[holder]; }

private:
    std::array<Vector2, 3> velocity_;
};

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
    const GroupState& g = s.groups;
    double sum = 0;
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        const std::int32_t node = scaling.members[i];
        const std::uint8_t holder = g.holder[g.component[i]];
        const Vector2 mean = mean_velocity(a, scaling, members, i, s, platens[holder], [&](std::int32_t k, std::int32_t j) {
            return g.component[j] == g.component[k] && holder == 0;
        });
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
void regroup(const Assemblage& a, const MassScaling& scaling, const PlatenVelocities& platens, std::int32_t group, State& s) {
    GroupState& g = s.groups;
    const Range members = scaling.groups[group];
    const Range ties = scaling.ties_of_group[group];
    const auto of_group = [&members](const auto& all) {
        return std::vector(all.begin() + members.begin, all.begin() + members.end);
    };
    const std::vector<std::int32_t> old_component = of_group(g.component);
    const std::vector<std::uint8_t> old_holder = of_group(g.holder);
    for (std::int32_t t = ties.begin; t < ties.end; ++t) {
        g.tied[t] = holds(scaling.ties[t], s) ? 1 : 0;
    }
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        g.supported[i] = s.touching[scaling.members[i]];
    }
    find_components(a, scaling, group, g);
    // First all part that will, with p = M' v of what is left; then those held together anew share it, v = M'⁻¹ p.
    const auto held_by = [&](std::int32_t i) { return old_holder[old_component[i - members.begin] - members.begin]; };
    const auto holder_now = [&](std::int32_t i) { return g.holder[g.component[i]]; };
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

/// Cuts groups into blocks.
void cut_blocks(MassScaling& m) {
    for (std::int32_t g = 0; g < static_cast<std::int32_t>(m.groups.size()); ++g) {
        if (m.groups[g].size() > members_per_block) {
            throw InputError(fmt::format("{} nodes meet at one vertex; mass scaling can take {}: use --mass-scaling none",
                                         m.groups[g].size(), members_per_block));
        }
        const bool fits = !m.blocks.empty() && m.blocks.back().size() < groups_per_block &&
                          m.groups[g].end - m.groups[m.blocks.back().begin].begin <= members_per_block;
        if (fits) {
            m.blocks.back().end = g + 1;
        } else {
            m.blocks.push_back({g, g + 1});
        }
    }
}

}  // namespace

MassScaling make_mass_scaling(const Assemblage& a, double factor) {
    MassScaling m;
    m.factor = factor;
    if (!m.is_on()) {
        return m;
    }
    const std::vector<std::int32_t> vertex = vertex_of_nodes(a);
    m.members.resize(a.position.size());
    std::iota(m.members.begin(), m.members.end(), 0);
    std::stable_sort(m.members.begin(), m.members.end(), [&](std::int32_t i, std::int32_t j) { return vertex[i] < vertex[j]; });
    std::vector<std::int32_t> member_of_node(a.position.size());
    std::vector<std::int32_t> group_of_node(a.position.size());
    std::int32_t n_groups = 0;
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        const std::int32_t node = m.members[i];
        n_groups += vertex[node] == node ? 1 : 0;  // the lowest node comes first
        member_of_node[node] = i;
        group_of_node[node] = n_groups - 1;
    }
    for (std::int32_t point = 0; point < 2 * a.n_contacts(); ++point) {
        const auto& nodes = a.contacts[point / 2].nodes;
        m.ties.push_back({member_of_node[nodes[point % 2]], member_of_node[nodes[2 + point % 2]], point,
                          group_reach * 2 * a.contacts[point / 2].point_area});
    }
    const auto group_of_tie = [&](const MassScaling::Tie& tie) { return group_of_node[m.members[tie.first]]; };
    std::stable_sort(m.ties.begin(), m.ties.end(),
                     [&](const MassScaling::Tie& l, const MassScaling::Tie& r) { return group_of_tie(l) < group_of_tie(r); });
    m.groups = ranges_of_groups(a.n_nodes(), n_groups, [&](std::int32_t i) { return group_of_node[m.members[i]]; });
    m.ties_of_group = ranges_of_groups(static_cast<std::int32_t>(m.ties.size()), n_groups,
                                       [&](std::int32_t t) { return group_of_tie(m.ties[t]); });
    cut_blocks(m);
    for (const std::int32_t node : m.members) {
        m.mass.insert(m.mass.end(), 2, a.mass[node]);
        m.inverse_mass.insert(m.inverse_mass.end(), 2, a.inverse_mass[node]);
    }
    return m;
}

GroupState make_group_state(const Assemblage& a, const MassScaling& scaling, const State& s) {
    GroupState g;
    g.component.resize(scaling.members.size());
    g.inverse_mass.resize(scaling.members.size());
    g.holder.resize(scaling.members.size());
    g.whole.resize(scaling.groups.size());
    g.sums.resize(scaling.blocks.size());
    for (const MassScaling::Tie& tie : scaling.ties) {
        g.tied.push_back(holds(tie, s) ? 1 : 0);
    }
    g.supported.resize(scaling.members.size());
    for (std::int32_t group = 0; group < static_cast<std::int32_t>(scaling.groups.size()); ++group) {
        find_components(a, scaling, group, g);
    }
    return g;
}

void complete_group_state(const MassScaling& scaling, State& s) {
    GroupState& g = s.groups;
    std::vector<bool> may_touch(s.touching.size(), false);
    for (const PlatenPoint& point : s.platen_points) {
        may_touch[point.node] = true;
    }
    g.holder.assign(scaling.members.size(), 0);
    for (std::size_t i = 0; i < scaling.members.size(); ++i) {
        std::uint8_t& holder = g.holder[g.component[i]];
        holder = std::max(holder, g.supported[i]);
    }
    g.whole.assign(scaling.groups.size(), 1);
    g.cracked.assign(scaling.blocks.size(), 0);
    g.platen_members.assign(scaling.blocks.size(), {});
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(scaling.blocks.size()); ++block) {
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
    g.block_of_point.resize(scaling.ties.size());
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(scaling.blocks.size()); ++block) {
        const Range groups = scaling.blocks[block];
        for (std::int32_t t = scaling.ties_of_group[groups.begin].begin; t < scaling.ties_of_group[groups.end - 1].end; ++t) {
            g.block_of_point[scaling.ties[t].point] = block;
            g.cracked[block] |= s.failed[scaling.ties[t].point];
        }
    }
}

namespace {

/// Whether a group of a block may have changed: a point of it has failed, or a platen has come or gone.
bool may_change(const MassScaling& scaling, std::int32_t block, const State& s) {
    const GroupState& g = s.groups;
    return g.cracked[block] != 0 || std::any_of(g.platen_members[block].begin(), g.platen_members[block].end(),
                                                [&](std::int32_t i) { return g.supported[i] != s.touching[scaling.members[i]]; });
}

}  // namespace

void update_groups(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t block,
                   State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    GroupState& g = s.groups;
    if (!may_change(scaling, block, s)) {
        return;
    }
    const PlatenVelocities platens(loading, parameters.time_step);
    for (std::int32_t group = scaling.blocks[block].begin; group < scaling.blocks[block].end; ++group) {
        const Range ties = scaling.ties_of_group[group];
        const Range members = scaling.groups[group];
        bool changes = false;
        for (std::int32_t t = ties.begin; t < ties.end; ++t) {
            changes = changes || (s.failed[scaling.ties[t].point] != 0 && holds(scaling.ties[t], s) != (g.tied[t] != 0));
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
        regroup(a, scaling, platens, group, s);
        g.sums[block].shed += before - energy();
    }
}

void shed_added_mass(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, double time_step,
                     State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const double shorter = 1 - time_step / parameters.time_step;
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(scaling.blocks.size()); ++block) {
        s.groups.sums[block].shed += added_kinetic_energy(a, parameters, loading, block, s) +
                                     shorter * half_impulse_work(parameters, scaling.members_of(block), s);
    }
}

// Damping and integration of a block's groups work on arrays on the stack: members side by side, x and y after each other, as
// both are treated alike. Sums over those held together are taken one by one; all else is for vector units.
namespace {

/// Members of a block.
struct Batch {
    static constexpr std::int32_t size = 2 * members_per_block;
    alignas(64) double force[size], velocity[size];                   ///< of the nodes
    alignas(64) double mean_acceleration[size], mean_velocity[size];  ///< of those they are held together with
    alignas(64) double mean_drag[size];                               ///< drag of the mean less the mean of drags, per mass
    alignas(64) double drag[size];
};

Vector2 pair_at(const double* values, std::int32_t i) { return {values[2 * i], values[2 * i + 1]}; }
void set_pair(double* values, std::int32_t i, const Vector2& pair) {
    values[2 * i] = pair.x;
    values[2 * i + 1] = pair.y;
}

void gather(const MassScaling& scaling, Range members, const State& s, Batch& b) {
    const Vector2* const force = s.force.data();
    const Vector2* const velocity = s.velocity.data();
    for (std::int32_t i = 0; i < members.size(); ++i) {
        const std::int32_t node = scaling.members[members.begin + i];
        set_pair(b.force, i, force[node]);
        set_pair(b.velocity, i, velocity[node]);
    }
}

/// Calls `whole(first, last)` for every group that is one component, `torn(first, last)` for all others; places within the block.
template <class Whole, class Torn>
void for_each_group(const MassScaling& scaling, std::int32_t block, const GroupState& g, Whole&& whole, Torn&& torn) {
    const Range groups = scaling.blocks[block];
    const std::int32_t origin = scaling.groups[groups.begin].begin;
    for (std::int32_t group = groups.begin; group < groups.end; ++group) {
        const Range members{scaling.groups[group].begin - origin, scaling.groups[group].end - origin};
        g.whole[group] != 0 ? whole(members) : torn(members);
    }
}

/// Mean acceleration and velocity of those held together.
void find_means(const MassScaling& scaling, std::int32_t block, const GroupState& g, Batch& b) {
    const std::int32_t origin = scaling.members_of(block).begin;
    const double* const mass = &scaling.mass[2 * static_cast<std::size_t>(origin)];
    for_each_group(
        scaling, block, g,
        [&](Range members) {
            Vector2 force;
            Vector2 momentum;
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                force += pair_at(b.force, i);
                momentum += mass[2 * i] * pair_at(b.velocity, i);
            }
            const double share = g.inverse_mass[origin + members.begin];
            const Vector2 acceleration = share * force;
            const Vector2 velocity = share * momentum;
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                set_pair(b.mean_acceleration, i, acceleration);
                set_pair(b.mean_velocity, i, velocity);
            }
        },
        [&](Range members) {
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                set_pair(b.mean_acceleration, i, {});
                set_pair(b.mean_velocity, i, {});
                const std::int32_t first = g.component[origin + i] - origin;
                const double share = g.inverse_mass[origin + first];
                set_pair(b.mean_acceleration, first, pair_at(b.mean_acceleration, first) + share * pair_at(b.force, i));
                set_pair(b.mean_velocity, first,
                         pair_at(b.mean_velocity, first) + (share * mass[2 * i]) * pair_at(b.velocity, i));
            }
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                const std::int32_t first = g.component[origin + i] - origin;
                set_pair(b.mean_acceleration, i, pair_at(b.mean_acceleration, first));
                set_pair(b.mean_velocity, i, pair_at(b.mean_velocity, first));
            }
        });
}

GRAINCRACK_INLINE double component_drag(double alpha, double force, double velocity) {
    return velocity == 0 ? 0.0 : -std::copysign(alpha * std::abs(force), velocity);
}

/// Drag of the relative motion of each.
GRAINCRACK_INLINE void damp_relative_motion(const double* mass, double alpha, std::int32_t count, Batch& b) {
    for (std::int32_t k = 0; k < count; ++k) {
        b.drag[k] = component_drag(alpha, b.force[k] - mass[k] * b.mean_acceleration[k], b.velocity[k] - b.mean_velocity[k]);
    }
}

/// Mean of these drags, to be taken off.
void find_mean_drags(const MassScaling& scaling, std::int32_t block, const GroupState& g, Batch& b) {
    const std::int32_t origin = scaling.members_of(block).begin;
    for_each_group(
        scaling, block, g,
        [&](Range members) {
            Vector2 drag;
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                drag += pair_at(b.drag, i);
            }
            const Vector2 mean = g.inverse_mass[origin + members.begin] * drag;
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                set_pair(b.mean_drag, i, mean);
            }
        },
        [&](Range members) {
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                set_pair(b.mean_drag, i, {});
                const std::int32_t first = g.component[origin + i] - origin;
                set_pair(b.mean_drag, first, pair_at(b.mean_drag, first) + g.inverse_mass[origin + first] * pair_at(b.drag, i));
            }
            for (std::int32_t i = members.begin; i < members.end; ++i) {
                set_pair(b.mean_drag, i, pair_at(b.mean_drag, g.component[origin + i] - origin));
            }
        });
}

/// Drag of both motions into `drag`, and the damped acceleration of the mean.
GRAINCRACK_INLINE void damp_mean_motion(const double* mass, double alpha, std::int32_t count, Batch& b) {
    for (std::int32_t k = 0; k < count; ++k) {
        const double mean = component_drag(alpha, b.mean_acceleration[k], b.mean_velocity[k]);
        b.drag[k] += mass[k] * (mean - b.mean_drag[k]);
        b.mean_acceleration[k] += mean;
    }
}

/// Calls `act(i, holder)` for every member of a block that a platen holds; places within the block.
template <class Act>
void for_each_held(const MassScaling& scaling, std::int32_t block, const GroupState& g, Act&& act) {
    if (g.platen_members[block].empty()) {
        return;
    }
    const Range members = scaling.members_of(block);
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        const std::uint8_t holder = g.holder[g.component[i]];
        if (holder != 0) {
            act(i - members.begin, holder);
        }
    }
}

/// Everything up to the drags of a block. The mean motion of those that a platen holds is the platen's, and is not damped.
void damp(const Assemblage& a, const StepParameters& parameters, const PlatenVelocities& platens, std::int32_t block,
          const State& s, Batch& b) {
    const MassScaling& scaling = parameters.mass_scaling;
    const Range members = scaling.members_of(block);
    const std::int32_t count = 2 * members.size();
    const double* const mass = &scaling.mass[2 * static_cast<std::size_t>(members.begin)];
    gather(scaling, members, s, b);
    find_means(scaling, block, s.groups, b);
    for_each_held(scaling, block, s.groups,
                  [&](std::int32_t i, std::uint8_t holder) { set_pair(b.mean_velocity, i, platens[holder]); });
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { damp_relative_motion(mass, parameters.damping, count, b); });
    find_mean_drags(scaling, block, s.groups, b);
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL { damp_mean_motion(mass, parameters.damping, count, b); });
}

/// v += Δt M'⁻¹ (F + Fd). \return twice the energy absorbed by damping over Δt, W
GRAINCRACK_INLINE double accelerate(const double* inverse_mass, double own, double time_step, std::int32_t count, Batch& b) {
    for (std::int32_t k = count; k % lanes != 0; ++k) {
        b.drag[k] = b.velocity[k] = b.mean_velocity[k] = 0;
    }
    // The new velocities into `mean_velocity`, which is not needed any more.
    for (std::int32_t k = 0; k < count; ++k) {
        const double mean = (1 - own) * b.mean_acceleration[k];
        b.mean_velocity[k] = b.velocity[k] + time_step * (mean + (own * inverse_mass[k]) * (b.force[k] + b.drag[k]));
    }
    double absorbed[lanes] = {};
    for (std::int32_t k = 0; k < count; k += lanes) {
        for (std::int32_t l = 0; l < lanes; ++l) {
            absorbed[l] -= b.drag[k + l] * (b.velocity[k + l] + b.mean_velocity[k + l]);
        }
    }
    return ((absorbed[0] + absorbed[1]) + (absorbed[2] + absorbed[3])) +
           ((absorbed[4] + absorbed[5]) + (absorbed[6] + absorbed[7]));
}

/// Of the platen that holds a component, m/s².
Vector2 platen_acceleration(const StepLoading& loading, double time_step, std::uint8_t holder) {
    const std::size_t platen = holder - 1U;
    return {0, (loading.increment_after[platen] - loading.increment_before[platen]) / (time_step * time_step)};
}

}  // namespace

void damp_groups(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t block,
                 State& s) {
    Batch b;
    damp(a, parameters, PlatenVelocities(loading, parameters.time_step), block, s, b);
    const Range members = parameters.mass_scaling.members_of(block);
    for (std::int32_t i = members.begin; i < members.end; ++i) {
        s.drag[parameters.mass_scaling.members[i]] = pair_at(b.drag, i - members.begin);
    }
}

void integrate_groups(const Assemblage& a, const StepParameters& parameters, const StepLoading& loading, std::int32_t block,
                      State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    const double dt = parameters.time_step;
    Batch b;
    damp(a, parameters, PlatenVelocities(loading, dt), block, s, b);
    for_each_held(scaling, block, s.groups, [&](std::int32_t i, std::uint8_t holder) {
        set_pair(b.mean_acceleration, i, platen_acceleration(loading, dt, holder));
    });
    const Range members = scaling.members_of(block);
    const double* const inverse_mass = &scaling.inverse_mass[2 * static_cast<std::size_t>(members.begin)];
    double absorbed = 0;
    run_on(a.vector_target,
           [&]() GRAINCRACK_KERNEL { absorbed = accelerate(inverse_mass, 1 / (1 + scaling.factor), dt, 2 * members.size(), b); });
    s.groups.sums[block].damping += 0.5 * dt * absorbed;
    for_each_held(scaling, block, s.groups, [&](std::int32_t i, std::uint8_t holder) {
        const Vector2 against_platen =
            (1 / dt) * (pair_at(b.mean_velocity, i) - pair_at(b.velocity, i)) - platen_acceleration(loading, dt, holder);
        const double force = -scaling.factor * scaling.mass[2 * (members.begin + i)] * against_platen.y;  // of the added mass
        s.groups.sums[block].platen_work +=
            0.5 * force * (loading.increment_before[holder - 1U] + loading.increment_after[holder - 1U]);
    });
    Vector2* const velocity = s.velocity.data();
    Vector2* const displacement = s.displacement.data();
    for (std::int32_t i = 0; i < members.size(); ++i) {
        const std::int32_t node = scaling.members[members.begin + i];
        const Vector2 moved = pair_at(b.mean_velocity, i);
        velocity[node] = moved;
        displacement[node] += dt * moved;
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
