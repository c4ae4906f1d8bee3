#include "solver/detection/active_contacts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/simd.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t batch_touches = 64;
constexpr std::int32_t lanes = 8;  // of the widest vector unit; any fixed number gives the same bytes everywhere

/// Ways and forces of touches side by side.
struct Batch {
    alignas(64) double along_x[batch_touches], along_y[batch_touches];  // from first to second node of the edge, m
    alignas(64) double from_x[batch_touches], from_y[batch_touches];    // from first to the node, m
    alignas(64) double node_x[batch_touches], node_y[batch_touches];    // way of the step, m
    alignas(64) double first_x[batch_touches], first_y[batch_touches], second_x[batch_touches], second_y[batch_touches];
    alignas(64) double tangent_x[batch_touches], tangent_y[batch_touches], inv_length[batch_touches];
    alignas(64) double place[batch_touches], depth[batch_touches];
    alignas(64) double force_x[3][batch_touches], force_y[3][batch_touches];
    alignas(64) double live[batch_touches], area[batch_touches], allowance[batch_touches];
    alignas(64) double pressing[batch_touches], stretch[batch_touches], pull[batch_touches];
    alignas(64) double friction[batch_touches];
};

void gather(const Assemblage& a, const State& s, double time_step, Range touches, Batch& b) {
    const std::array<std::int32_t, 3>* const nodes = &s.touches.moving.nodes[touches.begin];
    const Vector2* const position = a.position.data();
    const Vector2* const displacement = s.displacement.data();
    const Vector2* const velocity = s.velocity.data();
    for (std::int32_t i = 0; i < touches.size(); ++i) {
        const auto [node, first, second] = nodes[i];
        const Vector2 on_first = position[first] + displacement[first];
        const Vector2 along = (position[second] + displacement[second]) - on_first;
        const Vector2 from_first = (position[node] + displacement[node]) - on_first;
        b.along_x[i] = along.x;
        b.along_y[i] = along.y;
        b.from_x[i] = from_first.x;
        b.from_y[i] = from_first.y;
        b.node_x[i] = time_step * velocity[node].x;
        b.node_y[i] = time_step * velocity[node].y;
        b.first_x[i] = time_step * velocity[first].x;
        b.first_y[i] = time_step * velocity[first].y;
        b.second_x[i] = time_step * velocity[second].x;
        b.second_y[i] = time_step * velocity[second].y;
    }
    const MovingTouches& moving = s.touches.moving;
    std::copy_n(&moving.live[touches.begin], touches.size(), b.live);
    std::copy_n(&moving.area[touches.begin], touches.size(), b.area);
    std::copy_n(&moving.allowance[touches.begin], touches.size(), b.allowance);
    std::copy_n(&moving.pressing[touches.begin], touches.size(), b.pressing);
    std::copy_n(&moving.stretch[touches.begin], touches.size(), b.stretch);
}

GRAINCRACK_INLINE void find_geometry(std::int32_t count, Batch& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        const TouchGeometry g = touch_geometry({b.along_x[i], b.along_y[i]}, {b.from_x[i], b.from_y[i]});
        b.tangent_x[i] = g.tangent.x;
        b.tangent_y[i] = g.tangent.y;
        b.inv_length[i] = g.inv_length;
        b.place[i] = g.place;
        b.depth[i] = g.depth;
    }
}

/// A node that is out where nothing presses ends its touch: it gives back what it owes (`Touch::pull`), and then nothing.
GRAINCRACK_INLINE void move(const ContactLaw& constants, std::int32_t count, Batch& b) {
    const ContactLaw law = constants;
    for (std::int32_t i = 0; i < count; ++i) {
        const Vector2 t{b.tangent_x[i], b.tangent_y[i]};
        const TouchGeometry g{t, {t.y, -t.x}, b.inv_length[i], b.place[i], b.depth[i]};
        const double sliding =
            sliding_along(g, {b.node_x[i], b.node_y[i]}, {b.first_x[i], b.first_y[i]}, {b.second_x[i], b.second_y[i]});
        const TouchResponse r =
            move_touch(law, {true, true, b.area[i], b.allowance[i], b.pressing[i], b.stretch[i], 0}, g, sliding);
        const double live = b.live[i];
        b.live[i] = g.depth <= std::min(b.allowance[i], 0.0) ? 0.0 : live;
        b.allowance[i] = r.touch.allowance;
        b.pressing[i] = r.touch.pressing;
        b.stretch[i] = r.touch.stretch;
        b.pull[i] = live * r.touch.pull;
        b.friction[i] = live * r.friction;
        b.force_x[0][i] = live * r.forces.on_node.x;
        b.force_y[0][i] = live * r.forces.on_node.y;
        b.force_x[1][i] = live * r.forces.on_first.x;
        b.force_y[1][i] = live * r.forces.on_first.y;
        b.force_x[2][i] = live * r.forces.on_second.x;
        b.force_y[2][i] = live * r.forces.on_second.y;
    }
    for (std::int32_t i = count; i % lanes != 0; ++i) {
        b.friction[i] = 0;
    }
}

/// Sum by lanes.
double sum_of(std::int32_t count, const double* values) {
    std::array<double, lanes> sum{};
    for (std::int32_t i = 0; i < count; i += lanes) {
        for (std::int32_t l = 0; l < lanes; ++l) {
            sum[l] += values[i + l];
        }
    }
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

void scatter(Range touches, const Batch& b, MovingTouches& moving) {
    std::copy_n(b.live, touches.size(), &moving.live[touches.begin]);
    std::copy_n(b.allowance, touches.size(), &moving.allowance[touches.begin]);
    std::copy_n(b.pressing, touches.size(), &moving.pressing[touches.begin]);
    std::copy_n(b.stretch, touches.size(), &moving.stretch[touches.begin]);
    std::copy_n(b.pull, touches.size(), &moving.pull[touches.begin]);
    std::copy_n(b.place, touches.size(), &moving.place[touches.begin]);
    Vector2* const forces = &moving.forces[3 * static_cast<std::size_t>(touches.begin)];
    for (std::int32_t i = 0; i < touches.size(); ++i) {
        for (std::int32_t k = 0; k < 3; ++k) {
            forces[3 * i + k] = {b.force_x[k][i], b.force_y[k][i]};
        }
    }
}

}  // namespace

void move_touches(const Assemblage& a, const StepParameters& parameters, std::int32_t block, State& s) {
    MovingTouches& moving = s.touches.moving;
    const std::int32_t begin = s.touches.first_awake(block);
    const std::int32_t end = begin + moving.count[block];
    Batch batch;
    for (std::int32_t at = begin; at < end; at += batch_touches) {
        const Range touches{at, std::min(at + batch_touches, end)};
        gather(a, s, parameters.time_step, touches, batch);
        run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
            find_geometry(touches.size(), batch);
            move(parameters.law, touches.size(), batch);
        });
        scatter(touches, batch, moving);
        s.touches.friction[block] += sum_of(touches.size(), batch.friction);
    }
}

void settle_touches(std::int32_t block, TouchList& list) {
    const MovingTouches& moving = list.moving;
    const std::int32_t begin = list.first_awake(block);
    for (std::int32_t i = begin; i < begin + moving.count[block]; ++i) {
        const auto pair = static_cast<std::size_t>(moving.pair[i]);
        const bool near_first = moving.place[i] < 0.5;
        list.touches[pair] = {moving.live[i] != 0, near_first,        moving.area[i], moving.allowance[i],
                              moving.pressing[i],  moving.stretch[i], moving.pull[i]};
        std::copy_n(&moving.forces[3 * static_cast<std::size_t>(i)], 3, &list.forces[3 * pair]);
    }
}

void append_moving(const Outline& outline, std::int32_t block, std::int32_t index, TouchList& list) {
    MovingTouches& moving = list.moving;
    const std::int32_t at = list.first_awake(block) + moving.count[block]++;
    const auto& [first, second] = outline.edges[list.pairs[index].edge].nodes;
    const Touch& touch = list.touches[index];
    moving.changed[block] = moving.changed[block] != 0 || moving.pair[at] != index ? 1 : 0;
    moving.pair[at] = index;
    moving.nodes[at] = {list.pairs[index].node, first, second};
    moving.live[at] = touch.active ? 1 : 0;
    moving.area[at] = touch.area;
    moving.allowance[at] = touch.allowance;
    moving.pressing[at] = touch.pressing;
    moving.stretch[at] = touch.stretch;
    moving.pull[at] = touch.pull;
    moving.place[at] = touch.near_first ? 0 : 1;
    std::copy_n(&list.forces[3 * static_cast<std::size_t>(index)], 3, &moving.forces[3 * static_cast<std::size_t>(at)]);
}

double stored_in_touches(const ContactLaw& law, const TouchList& list) {
    double energy = 0;
    list.for_moving([&](std::int32_t i) {
        const Touch& touch = list.touches[list.moving.pair[i]];
        energy += touch.active ? touch_energy(law, touch) : 0;
    });
    return energy;
}

void take_up_touches(const Assemblage& a, TouchList& list) {
    MovingTouches& moving = list.moving;
    const std::size_t n = list.awake.size();
    moving.pair.assign(n, -1);
    moving.nodes.resize(n);
    for (auto* values :
         {&moving.live, &moving.area, &moving.allowance, &moving.pressing, &moving.stretch, &moving.pull, &moving.place}) {
        values->resize(n);
    }
    moving.forces.resize(3 * n);
    moving.count.assign(list.blocks.size(), 0);
    moving.changed.assign(list.blocks.size(), 0);
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(list.blocks.size()); ++block) {
        const std::int32_t end = list.awake_groups[list.blocks[block].end - 1].end;
        for (std::int32_t i = list.first_awake(block); i < end; ++i) {
            const Touch& touch = list.touches[list.awake[i]];
            if (touch.active || touch.pull != 0) {
                append_moving(a.outline, block, list.awake[i], list);
            }
        }
    }
    arrange_gathers(a, list);
}

void arrange_gathers(const Assemblage& a, TouchList& list) {
    const MovingTouches& moving = list.moving;
    const auto for_forces = [&](auto&& act) {
        list.for_moving([&](std::int32_t i) {
            for (std::int32_t k = 0; k < 3; ++k) {
                act(moving.nodes[i][k], 3 * i + k);
            }
        });
    };
    list.gathers.clear();
    if (std::all_of(moving.count.begin(), moving.count.end(), [](std::int32_t count) { return count == 0; })) {
        std::fill(list.gathers_of_block.begin(), list.gathers_of_block.end(), Range{});
        return;
    }
    std::vector<std::int32_t>& end_of_node = list.gather_scratch;  // where the next force of a node goes
    end_of_node.assign(a.position.size(), 0);
    std::int32_t total = 0;
    for_forces([&](std::int32_t node, std::int32_t /*slot*/) {
        ++end_of_node[node];
        ++total;
    });
    list.gathered_slots.resize(total);
    std::int32_t at = 0;
    for (std::size_t block = 0; block < a.grain_blocks.size(); ++block) {
        const auto first = static_cast<std::int32_t>(list.gathers.size());
        for (std::int32_t node = a.grain_blocks[block].nodes.begin; node < a.grain_blocks[block].nodes.end; ++node) {
            if (const std::int32_t count = end_of_node[node]; count > 0) {
                list.gathers.push_back({node, {at, at + count}});
                end_of_node[node] = at;
                at += count;
            }
        }
        list.gathers_of_block[block] = {first, static_cast<std::int32_t>(list.gathers.size())};
    }
    for_forces([&](std::int32_t node, std::int32_t slot) { list.gathered_slots[end_of_node[node]++] = slot; });
}

}  // namespace graincrack
