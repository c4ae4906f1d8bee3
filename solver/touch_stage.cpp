// The touch stage of a step: every listed node against the edges near it. A block of nodes is worked on in passes: where they are
// (side by side), what becomes of their touches (one by one), how these move (side by side), and which begin.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "solver/state.hpp"
#include "solver/step.hpp"
#include "solver/touch_geometries.hpp"
#include "solver/touch_list.hpp"

namespace graincrack {
namespace {

using namespace touch_rule;

constexpr double bond_width = 3e-3;  // of the mean edge: a node no farther behind a bonded edge is in the bond, not in the grain
constexpr double least_area = 0.1;   // of what a node stands for, in a crowd
constexpr double aligned = 0.5;      // cosine of two normals up to which two edges count as one surface
constexpr double corner = 0.05;      // sine of a turn of the outline from which on its two edges are two faces

/// A touch that goes on.
struct Moving {
    std::int32_t at;    ///< in the block
    std::int32_t pair;  ///< in the list
    bool is_last;       ///< the node is out and nothing presses: it gives back what it owes (`Touch::pull`) and ends
};

/// What a block of nodes is worked on with.
struct Block {
    const Assemblage& assemblage;
    const StepParameters& parameters;
    State& state;
    TouchGeometries& geometry;  ///< by place among the block's awake pairs
    std::vector<Moving>& moving;
    double friction = 0;
};

/// Room for a block's work, kept from call to call.
struct Scratch {
    TouchGeometries geometry;
    std::vector<Moving> moving;
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

/// Whether nothing presses any more at the depth of a node that is out: the touch ends with this step.
bool has_left(const Touch& touch, double depth) { return depth <= 0 && depth <= std::min(touch.allowance, 0.0); }

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

/// Decides how the touches of a node go on; `moving` are those that do.
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
            group.block.moving.push_back({group.at(on), group.pair(on), has_left(group.touch(on), group.depth(on))});
        }
    }
}

/// Touches side by side.
struct Batch {
    static constexpr std::int32_t size = 64;
    alignas(64) double tangent_x[size], tangent_y[size], inv_length[size], place[size], depth[size];
    alignas(64) double node_x[size], node_y[size], first_x[size], first_y[size], second_x[size], second_y[size];  // of the step
    alignas(64) double area[size], allowance[size], pressing[size], stretch[size], pull[size], friction[size];
    alignas(64) double force_x[3][size], force_y[3][size];
};

GRAINCRACK_INLINE void move(const ContactLaw& constants, std::int32_t count, Batch& b) {
    const ContactLaw law = constants;
    for (std::int32_t i = 0; i < count; ++i) {
        const Vector2 t{b.tangent_x[i], b.tangent_y[i]};
        const TouchGeometry g{t, {t.y, -t.x}, b.inv_length[i], b.place[i], b.depth[i]};
        const double sliding =
            sliding_along(g, {b.node_x[i], b.node_y[i]}, {b.first_x[i], b.first_y[i]}, {b.second_x[i], b.second_y[i]});
        const TouchResponse r =
            move_touch(law, {true, true, b.area[i], b.allowance[i], b.pressing[i], b.stretch[i], 0}, g, sliding);
        b.allowance[i] = r.touch.allowance;
        b.pressing[i] = r.touch.pressing;
        b.stretch[i] = r.touch.stretch;
        b.pull[i] = r.touch.pull;
        b.friction[i] = r.friction;
        b.force_x[0][i] = r.forces.on_node.x;
        b.force_y[0][i] = r.forces.on_node.y;
        b.force_x[1][i] = r.forces.on_first.x;
        b.force_y[1][i] = r.forces.on_first.y;
        b.force_x[2][i] = r.forces.on_second.x;
        b.force_y[2][i] = r.forces.on_second.y;
    }
}

void gather(const Block& block, std::span<const Moving> moving, Batch& b) {
    const TouchList& list = block.state.touches;
    const Vector2* const velocity = block.state.velocity.data();
    const double dt = block.parameters.time_step;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const TouchPair& pair = list.pairs[moving[i].pair];
        const auto [first, second] = block.assemblage.outline.edges[pair.edge].nodes;
        const TouchGeometry g = block.geometry[moving[i].at];
        const Touch& touch = list.touches[moving[i].pair];
        b.tangent_x[i] = g.tangent.x;
        b.tangent_y[i] = g.tangent.y;
        b.inv_length[i] = g.inv_length;
        b.place[i] = g.place;
        b.depth[i] = g.depth;
        b.node_x[i] = dt * velocity[pair.node].x;
        b.node_y[i] = dt * velocity[pair.node].y;
        b.first_x[i] = dt * velocity[first].x;
        b.first_y[i] = dt * velocity[first].y;
        b.second_x[i] = dt * velocity[second].x;
        b.second_y[i] = dt * velocity[second].y;
        b.area[i] = touch.area;
        b.allowance[i] = touch.allowance;
        b.pressing[i] = touch.pressing;
        b.stretch[i] = touch.stretch;
    }
}

void scatter(Block& block, std::span<const Moving> moving, const Batch& b) {
    TouchList& list = block.state.touches;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const std::int32_t pair = moving[i].pair;
        list.touches[pair] = {!moving[i].is_last, b.place[i] < 0.5, b.area[i], b.allowance[i],
                              b.pressing[i],      b.stretch[i],     b.pull[i]};
        for (std::size_t k = 0; k < 3; ++k) {
            list.forces[3 * static_cast<std::size_t>(pair) + k] = {b.force_x[k][i], b.force_y[k][i]};
        }
        block.friction += b.friction[i];
    }
}

/// Moves the touches that go on to where their nodes are.
void move(Block& block) {
    Batch batch;
    const std::span<const Moving> all = block.moving;
    for (std::size_t begin = 0; begin < all.size(); begin += Batch::size) {
        const auto part = all.subspan(begin, std::min<std::size_t>(Batch::size, all.size() - begin));
        const auto count = static_cast<std::int32_t>(part.size());
        gather(block, part, batch);
        run_on(block.assemblage.vector_target, [&]() GRAINCRACK_KERNEL { move(block.parameters.law, count, batch); });
        scatter(block, part, batch);
    }
}

/// Area of a new touch: what the node stands for, or less where node or edge are held by others already.
double area_of(const Group& group, std::int32_t i) {
    const std::vector<double>& room = group.block.state.touches.room;
    const double tributary = group.block.assemblage.outline.tributary[group.node()];
    const std::int32_t end = group.edge(i).nodes[group.geometry(i).place < 0.5 ? 0 : 1];
    return std::clamp(std::min(room[group.node()], room[end]), least_area * tributary, tributary);
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

void advance_touches(const Assemblage& a, const StepParameters& parameters, std::int32_t index, State& s) {
    const Range groups = s.touches.blocks[index];
    const std::int32_t origin = s.touches.awake_groups[groups.begin].begin;
    const std::int32_t count = s.touches.awake_groups[groups.end - 1].end - origin;
    prefetch(s.touches, {origin, origin + count});
    static thread_local Scratch scratch;
    scratch.moving.clear();
    Block block{a, parameters, s, scratch.geometry, scratch.moving};
    block.geometry.find(a, s, count, [&](std::int32_t i) { return s.touches.awake[origin + i]; });
    const auto for_groups = [&](auto&& act) {
        for (std::int32_t i = groups.begin; i < groups.end; ++i) {
            Group group{block, s.touches.awake_groups[i], origin};
            act(group);
        }
    };
    for_groups([](Group& group) { carry_on(group); });
    move(block);
    for_groups(begin_touches);
    s.touches.friction[index] += block.friction;
}

double stored_in_touches(const ContactLaw& law, const TouchList& list) {
    double energy = 0;
    for (const Touch& touch : list.touches) {
        energy += touch.active ? touch_energy(law, touch) : 0;
    }
    return energy;
}

}  // namespace graincrack
