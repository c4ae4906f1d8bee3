// The touch stage of a step: every listed node against the edges near it.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/state.hpp"
#include "solver/step.hpp"
#include "solver/touch_list.hpp"

namespace graincrack {
namespace {

using namespace touch_rule;

constexpr double bond_width = 3e-3;  // of the mean edge: a node no farther behind a bonded edge is in the bond, not in the grain
constexpr double least_area = 0.1;   // of what a node stands for, in a crowd
constexpr double aligned = 0.5;      // cosine of two normals up to which two edges count as one surface
constexpr double corner = 0.05;      // sine of a turn of the outline from which on its two edges are two faces

/// The awake pairs of one node.
struct Group {
    const Assemblage& assemblage;
    const ContactLaw& law;
    double time_step;
    State& state;
    Range awake;
    std::vector<TouchGeometry>& geometry;  ///< by place in the group
    double friction = 0;

    [[nodiscard]] std::int32_t size() const { return awake.size(); }
    [[nodiscard]] std::int32_t pair(std::int32_t i) const { return state.touches.awake[awake.begin + i]; }
    [[nodiscard]] std::int32_t edge_index(std::int32_t i) const { return state.touches.pairs[pair(i)].edge; }
    [[nodiscard]] const OutlineEdge& edge(std::int32_t i) const { return assemblage.outline.edges[edge_index(i)]; }
    [[nodiscard]] Touch& touch(std::int32_t i) const { return state.touches.touches[pair(i)]; }
    [[nodiscard]] Vector2* forces(std::int32_t i) const { return &state.touches.forces[3 * static_cast<std::size_t>(pair(i))]; }
    [[nodiscard]] std::int32_t node() const { return state.touches.pairs[pair(0)].node; }
};

bool is_over(const TouchGeometry& g, double beyond) { return g.place >= -beyond && g.place <= 1 + beyond; }

void find_geometry(Group& group) {
    const auto place_of = [&](std::int32_t n) { return group.assemblage.position[n] + group.state.displacement[n]; };
    const Vector2 node = place_of(group.node());
    group.geometry.clear();
    for (std::int32_t i = 0; i < group.size(); ++i) {
        const auto& [first, second] = group.edge(i).nodes;
        group.geometry.push_back(touch_geometry(node, place_of(first), place_of(second)));
    }
}

/// Of the two edges that follow edge `i` around a convex corner of the grain, the one whose face the node is nearer to than
/// `depth`; −1 if there is none in the list.
std::int32_t nearer_face(const Group& group, std::int32_t i, double depth) {
    const OutlineEdge& edge = group.edge(i);
    const Vector2& t = group.geometry[i].tangent;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < group.size(); ++k) {
        const std::int32_t index = group.edge_index(k);
        if (index != edge.previous && index != edge.next) {
            continue;
        }
        const Vector2& other = group.geometry[k].tangent;
        const double turn = t.x * other.y - t.y * other.x;
        const bool convex = index == edge.next ? turn > corner : turn < -corner;
        if (convex && !group.touch(k).active && group.geometry[k].depth < depth) {
            depth = group.geometry[k].depth;
            found = k;
        }
    }
    return found;
}

/// Where a node that has left edge `i` at its end goes on: the edge of the same surface whose depth differs least; −1 for none.
std::int32_t next_edge(const Group& group, std::int32_t i) {
    const TouchGeometry& from = group.geometry[i];
    double nearest = slack / from.inv_length;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < group.size(); ++k) {
        const TouchGeometry& g = group.geometry[k];
        const double step = std::abs(g.depth - from.depth);
        if (k != i && !group.touch(k).active && is_over(g, slack) && dot(g.normal, from.normal) > aligned && step < nearest) {
            nearest = step;
            found = k;
        }
    }
    return found;
}

/// Ends a touch; what its springs still hold is lost as the node slips off.
void end_touch(Group& group, std::int32_t i) {
    group.friction += touch_energy(group.law, group.touch(i));
    group.touch(i) = Touch{};
}

/// Passes a touch on to edge `to` with its force and energy.
void pass_on(Group& group, std::int32_t from, std::int32_t to) {
    Touch touch = group.touch(from);
    touch.allowance = group.geometry[to].depth - touch.pressing;
    group.touch(to) = touch;
    group.touch(from) = Touch{};
}

/// The edge on which touch `i` goes on; −1 if it ends.
std::int32_t carry_on(Group& group, std::int32_t i) {
    std::int32_t on = i;
    if (const std::int32_t face = nearer_face(group, i, group.geometry[i].depth - group.touch(i).allowance); face >= 0) {
        on = group.geometry[face].depth > 0 ? face : -1;
    } else if (!is_over(group.geometry[i], slack)) {
        on = next_edge(group, i);
    }
    if (on < 0) {
        end_touch(group, i);
    } else if (on != i) {
        pass_on(group, i, on);
    }
    return on;
}

void move(Group& group, std::int32_t i) {
    const auto stepped = [&](std::int32_t n) { return group.time_step * group.state.velocity[n]; };
    const auto& [first, second] = group.edge(i).nodes;
    const TouchGeometry& g = group.geometry[i];
    const double sliding = sliding_along(g, stepped(group.node()), stepped(first), stepped(second));
    const TouchResponse r = move_touch(group.law, group.touch(i), g, sliding);
    group.friction += r.friction;
    group.touch(i) = r.touch;
    if (g.depth <= 0 && r.touch.pressing == 0) {
        group.touch(i) = Touch{};
    }
    Vector2* slots = group.forces(i);
    slots[0] = r.forces.on_node;
    slots[1] = r.forces.on_first;
    slots[2] = r.forces.on_second;
}

/// Area of a new touch: what the node stands for, or less where node or edge are held by others already.
double area_of(const Group& group, std::int32_t i) {
    const std::vector<double>& room = group.state.touches.room;
    const double tributary = group.assemblage.outline.tributary[group.node()];
    const std::int32_t end = group.edge(i).nodes[group.geometry[i].place < 0.5 ? 0 : 1];
    return std::clamp(std::min(room[group.node()], room[end]), least_area * tributary, tributary);
}

/// Whether a touch may begin: the node is in the grain, and nothing else keeps it out of there.
bool may_begin(const Group& group, std::int32_t i) {
    const TouchGeometry& g = group.geometry[i];
    if (group.touch(i).active || g.depth <= 0 || !is_over(g, 0)) {
        return false;
    }
    const bool is_deep = g.depth > deep * group.assemblage.outline.mean_length;
    if (!is_deep && !is_over(g, -corner_zone)) {
        return false;
    }
    for (std::int32_t k = 0; k < group.size(); ++k) {
        if (group.touch(k).active &&
            (group.edge(k).grain == group.edge(i).grain || (!is_deep && dot(group.geometry[k].normal, g.normal) > aligned))) {
            return false;
        }
    }
    return !came_through_neighbour(group.assemblage, group.state, group.state.touches.pairs[group.pair(i)], g, 0);
}

void begin_touches(Group& group) {
    for (std::int32_t i = 0; i < group.size(); ++i) {
        if (may_begin(group, i)) {
            Touch& touch = group.touch(i);
            touch.active = true;
            touch.area = area_of(group, i);
            touch.allowance = group.geometry[i].depth;
        }
    }
}

void advance_group(Group& group) {
    find_geometry(group);
    std::array<std::int32_t, 16> moving{};
    std::size_t count = 0;
    for (std::int32_t i = 0; i < group.size(); ++i) {
        std::fill_n(group.forces(i), 3, Vector2{});
        if (group.touch(i).active && count < moving.size()) {
            moving[count++] = i;
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (const std::int32_t on = carry_on(group, moving[k]); on >= 0) {
            move(group, on);
        }
    }
    begin_touches(group);
}

/// Whether an edge belongs to a contact that has not been released and is not one of the node.
bool is_between_others(const Assemblage& a, const State& s, std::int32_t node, const OutlineEdge& edge) {
    if (edge.contact < 0 || s.touches.released[edge.contact] != 0) {
        return false;
    }
    const auto& nodes = a.contacts[edge.contact].nodes;
    return std::find(nodes.begin(), nodes.end(), node) == nodes.end();
}

}  // namespace

bool came_through_neighbour(const Assemblage& a, const State& s, const TouchPair& pair, const TouchGeometry& g, double margin) {
    const auto place_of = [&](std::int32_t n) { return a.position[n] + s.displacement[n]; };
    const OutlineEdge& edge = a.outline.edges[pair.edge];
    const Vector2 node = place_of(pair.node);
    for (const std::int32_t index : {edge.previous, edge.next}) {
        if (index < 0) {
            continue;
        }
        const OutlineEdge& neighbour = a.outline.edges[index];
        const TouchGeometry other = touch_geometry(node, place_of(neighbour.nodes[0]), place_of(neighbour.nodes[1]));
        const double turn = g.tangent.x * other.tangent.y - g.tangent.y * other.tangent.x;
        const bool convex = index == edge.next ? turn > corner : turn < -corner;
        const double front =
            is_between_others(a, s, pair.node, neighbour) ? std::min(g.depth, bond_width * a.outline.mean_length) : g.depth;
        if (convex && other.depth < front - margin) {
            return true;
        }
    }
    return false;
}

void advance_touches(const Assemblage& a, const StepParameters& parameters, std::int32_t block, State& s) {
    const Range groups = s.touches.blocks[block];
    std::vector<TouchGeometry> geometry;
    for (std::int32_t i = groups.begin; i < groups.end; ++i) {
        Group group{a, parameters.law, parameters.time_step, s, s.touches.awake_groups[i], geometry};
        advance_group(group);
        s.touches.friction[block] += group.friction;
    }
}

double stored_in_touches(const ContactLaw& law, const TouchList& list) {
    double energy = 0;
    for (const Touch& touch : list.touches) {
        energy += touch.active ? touch_energy(law, touch) : 0;
    }
    return energy;
}

}  // namespace graincrack
