#include "solver/detection/contact_detection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/pair_geometry.hpp"

namespace graincrack {
namespace {

using namespace touch_rule;

constexpr double bond_width = 3e-3;  // of the mean edge: a node no farther behind a bonded edge is in the bond, not in the grain
constexpr double least_area = 0.1;   // of what a node stands for, in a crowd
constexpr double aligned = 0.5;      // cosine of two normals up to which two edges count as one surface
constexpr double corner = 0.05;      // sine of a turn of the outline from which on its two edges are two faces

/// What a block of nodes is worked on with.
struct Block {
    const Assemblage& assemblage;
    const StepParameters& parameters;
    State& state;
    TouchGeometries& geometry;  ///< by place among the block's awake pairs
    std::int32_t index;
    double friction = 0;
};

/// Asks for what a block of awake pairs remembers: the list is long, and they lie scattered in it.
void prefetch(const TouchList& list, Range awake) {
    for (std::int32_t i = awake.begin; i < awake.end; ++i) {
        const auto pair = static_cast<std::size_t>(list.awake[i]);
        __builtin_prefetch(&list.touches[pair]);
        __builtin_prefetch(&list.touches[pair].pull);
    }
}

/// The awake pairs of one node.
struct Group {
    Block& block;
    Range awake;
    std::int32_t origin;  ///< first awake pair of the block

    [[nodiscard]] std::int32_t size() const { return awake.size(); }
    [[nodiscard]] std::int32_t at(std::int32_t i) const { return awake.begin - origin + i; }
    [[nodiscard]] std::int32_t pair(std::int32_t i) const { return block.state.touches.awake[awake.begin + i]; }
    [[nodiscard]] std::int32_t edge_index(std::int32_t i) const { return block.state.touches.pairs[pair(i)].edge; }
    [[nodiscard]] const OutlineEdge& edge(std::int32_t i) const { return block.assemblage.outline.edges[edge_index(i)]; }
    [[nodiscard]] Touch& touch(std::int32_t i) const { return block.state.touches.touches[pair(i)]; }
    [[nodiscard]] Vector2* forces(std::int32_t i) const {
        return &block.state.touches.forces[3 * static_cast<std::size_t>(pair(i))];
    }
    [[nodiscard]] std::int32_t node() const { return block.state.touches.pairs[pair(0)].node; }
    [[nodiscard]] TouchGeometry geometry(std::int32_t i) const { return block.geometry[at(i)]; }
    [[nodiscard]] double depth(std::int32_t i) const { return block.geometry.depth(at(i)); }
};

bool is_over(const TouchGeometry& g, double beyond) { return g.place >= -beyond && g.place <= 1 + beyond; }

/// Of the two edges that follow edge `i` around a convex corner of the grain, the one whose face the node is nearer to than
/// `depth`; −1 if there is none in the list.
std::int32_t nearer_face(const Group& group, std::int32_t i, double depth) {
    const OutlineEdge& edge = group.edge(i);
    const Vector2 t = group.geometry(i).tangent;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < group.size(); ++k) {
        const std::int32_t index = group.edge_index(k);
        if (index != edge.previous && index != edge.next) {
            continue;
        }
        const Vector2 other = group.geometry(k).tangent;
        const double turn = t.x * other.y - t.y * other.x;
        const bool convex = index == edge.next ? turn > corner : turn < -corner;
        if (convex && !group.touch(k).active && group.depth(k) < depth) {
            depth = group.depth(k);
            found = k;
        }
    }
    return found;
}

/// Where a node that has left edge `i` at its end goes on: the edge of the same surface whose depth differs least; −1 for none.
std::int32_t next_edge(const Group& group, std::int32_t i) {
    const TouchGeometry from = group.geometry(i);
    double nearest = slack / from.inv_length;
    std::int32_t found = -1;
    for (std::int32_t k = 0; k < group.size(); ++k) {
        const TouchGeometry g = group.geometry(k);
        const double step = std::abs(g.depth - from.depth);
        if (k != i && !group.touch(k).active && is_over(g, slack) && dot(g.normal, from.normal) > aligned && step < nearest) {
            nearest = step;
            found = k;
        }
    }
    return found;
}

/// Takes a touch and its forces away.
void clear(Group& group, std::int32_t i) {
    group.touch(i) = Touch{};
    std::fill_n(group.forces(i), 3, Vector2{});
}

/// Ends a touch; what its springs still hold is lost as the node slips off.
void end_touch(Group& group, std::int32_t i) {
    group.block.friction += touch_energy(group.block.parameters.law, group.touch(i));
    clear(group, i);
}

/// Passes a touch on to edge `to` with its force and energy.
void pass_on(Group& group, std::int32_t from, std::int32_t to) {
    Touch touch = group.touch(from);
    touch.allowance = group.depth(to) - touch.pressing;
    group.touch(to) = touch;
    clear(group, from);
}

/// The edge on which touch `i` goes on; −1 if it ends.
std::int32_t carry_on(Group& group, std::int32_t i) {
    std::int32_t on = i;
    if (const std::int32_t face = nearer_face(group, i, group.depth(i) - group.touch(i).allowance); face >= 0) {
        on = group.depth(face) > 0 ? face : -1;
    } else if (!is_over(group.geometry(i), slack)) {
        on = next_edge(group, i);
    }
    if (on < 0) {
        end_touch(group, i);
    } else if (on != i) {
        pass_on(group, i, on);
    }
    return on;
}

/// Decides how the touches of a node go on; those that do move.
void carry_on(Group& group) {
    std::array<std::int32_t, 16> active{};
    std::size_t count = 0;
    for (std::int32_t i = 0; i < group.size(); ++i) {
        Touch& touch = group.touch(i);
        if (touch.active && count < active.size()) {
            active[count++] = i;
        } else if (!touch.active && touch.pull != 0) {
            clear(group, i);
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (const std::int32_t on = carry_on(group, active[k]); on >= 0) {
            append_moving(group.block.assemblage.outline, group.block.index, group.pair(on), group.block.state.touches);
        }
    }
}

/// The area a node can still take: what its bonds had at the start, which the stable step knows of, less what its bonds and
/// touches take now. Many corners on the end of one edge would be stiffer together than any bond was.
double room_of(const Outline& outline, const std::vector<ContactGeometry>& contacts, const TouchList& list, std::int32_t node) {
    double room = 2 * outline.tributary[node] - list.taken[node];
    for (std::int32_t k = outline.edge_begin[node]; k < outline.edge_begin[node + 1]; ++k) {
        const std::int32_t contact = outline.edges[outline.edges_of_node[k]].contact;
        room -= contact >= 0 && list.released[contact] == 0 ? contacts[contact].point_area : 0.0;
    }
    return room;
}

/// Area of a new touch: what the node stands for, or less where node or edge are held by others already.
double area_of(const Group& group, std::int32_t i) {
    const Assemblage& a = group.block.assemblage;
    const auto room = [&](std::int32_t node) { return room_of(a.outline, a.contacts, group.block.state.touches, node); };
    const double tributary = a.outline.tributary[group.node()];
    const std::int32_t end = group.edge(i).nodes[group.geometry(i).place < 0.5 ? 0 : 1];
    return std::clamp(std::min(room(group.node()), room(end)), least_area * tributary, tributary);
}

/// Whether a touch may begin: the node is in the grain, and nothing else keeps it out of there.
bool may_begin(const Group& group, std::int32_t i) {
    const TouchGeometry g = group.geometry(i);
    if (group.touch(i).active || g.depth <= 0 || !is_over(g, 0)) {
        return false;
    }
    const bool is_deep = g.depth > deep * group.block.assemblage.outline.mean_length;
    if (!is_deep && !is_over(g, -corner_zone)) {
        return false;
    }
    for (std::int32_t k = 0; k < group.size(); ++k) {
        if (group.touch(k).active &&
            (group.edge(k).grain == group.edge(i).grain || (!is_deep && dot(group.geometry(k).normal, g.normal) > aligned))) {
            return false;
        }
    }
    return !came_through_neighbour(group.block.assemblage, group.block.state, group.block.state.touches.pairs[group.pair(i)], g,
                                   0);
}

void begin_touches(Group& group) {
    for (std::int32_t i = 0; i < group.size(); ++i) {
        if (may_begin(group, i)) {
            const TouchGeometry g = group.geometry(i);
            group.touch(i) = {true, g.place < 0.5, area_of(group, i), g.depth, 0, 0, 0};
            append_moving(group.block.assemblage.outline, group.block.index, group.pair(i), group.block.state.touches);
        }
    }
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

void review_touches(const Assemblage& a, const StepParameters& parameters, std::int32_t index, State& s) {
    TouchList& list = s.touches;
    const Range groups = list.blocks[index];
    const std::int32_t origin = list.first_awake(index);
    const std::int32_t count = list.awake_groups[groups.end - 1].end - origin;
    prefetch(list, {origin, origin + count});
    settle_touches(index, list);
    static thread_local TouchGeometries geometry;
    Block block{a, parameters, s, geometry, index};
    geometry.find(a, s, count, [&](std::int32_t i) { return list.awake[origin + i]; });
    const auto for_groups = [&](auto&& act) {
        for (std::int32_t i = groups.begin; i < groups.end; ++i) {
            Group group{block, list.awake_groups[i], origin};
            act(group);
        }
    };
    const std::int32_t before = list.moving.count[index];
    list.moving.count[index] = 0;
    list.moving.changed[index] = 0;
    for_groups([](Group& group) { carry_on(group); });
    move_touches(a, parameters, index, s);
    settle_touches(index, list);
    for_groups(begin_touches);
    list.moving.changed[index] = list.moving.changed[index] != 0 || list.moving.count[index] != before ? 1 : 0;
    list.friction[index] += block.friction;
}

}  // namespace graincrack
