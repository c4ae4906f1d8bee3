// The state of ranks, brought together, is that of a rank alone; taken apart again, each rank has its own.
#include "solver/restart/whole_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "share/base/error.hpp"
#include "tests/support/crushed_run.hpp"
#include "tests/support/thread_ranks.hpp"

namespace graincrack {
namespace {

using test::Crush;
using test::crushed_run;
using test::on_thread_ranks;
using test::same_bytes;
using test::SmallRun;

const std::vector<Crush>& crushes() {
    static const std::vector<Crush> rows{{.confining_pressure = 2e6},
                                         {.law = LawVariant::cohesive_frictional, .has_phases = true},
                                         {.mass_scaling_factor = 0, .speed = 12, .n_steps = 2500}};
    return rows;
}
const SmallRun& crushed_alone(std::size_t row) {
    static const std::vector<SmallRun> runs = [] {
        std::vector<SmallRun> all;
        for (const Crush& crush : crushes()) all.push_back(crushed_run(crush));
        return all;
    }();
    return runs[row];
}
/// Calls `check` with the number of a row of `crushes` and a number of ranks.
template <class Check>
void for_some_ranks(const Check& check) {
    for (const auto& [row, n] : {std::pair(0U, 2), std::pair(0U, 3), std::pair(0U, 4), std::pair(1U, 3), std::pair(2U, 2)}) {
        SCOPED_TRACE(std::to_string(row) + " on " + std::to_string(n));
        check(row, n);
    }
}

/// A contact that has ended is none: what is left of it, its owner alone has.
auto numbers_of(const NodeEdgeContact& contact) {
    const NodeEdgeContact c = contact.active || contact.release_correction != 0 ? contact : NodeEdgeContact{};
    return std::tuple(c.active, c.near_first, c.area, c.initial_overlap, c.overlap, c.elastic_slip, c.release_correction);
}
auto numbers_of(const PlatenPoint& p) {
    return std::tuple(p.node, p.platen, p.tributary, p.gap, p.anchor, p.shear, p.on_boundary);
}
template <class Item>
bool have_same_numbers(const std::vector<Item>& l, const std::vector<Item>& r) {
    return std::equal(l.begin(), l.end(), r.begin(), r.end(),
                      [](const Item& a, const Item& b) { return numbers_of(a) == numbers_of(b); });
}
/// The active contacts of each chunk, in their order.
std::vector<std::int32_t> active_pairs(const ContactPairList& list) {
    std::vector<std::int32_t> pairs;
    list.for_active([&](std::int32_t i) { pairs.push_back(list.active.pair[i]); });
    return pairs;
}
std::vector<std::int32_t> bounds_of(const std::vector<Range>& ranges) {
    std::vector<std::int32_t> bounds;
    for (const Range& range : ranges) bounds.insert(bounds.end(), {range.begin, range.end});
    return bounds;
}

void expect_same_points(const State& l, const State& r) {
    for (const auto of_points : {&State::opening, &State::sliding, &State::integrity, &State::slip, &State::next_mark,
                                 &State::fracture_energy, &State::contact_force}) {
        EXPECT_TRUE(same_bytes(l.*of_points, r.*of_points));
    }
    EXPECT_EQ(l.failed, r.failed);
    EXPECT_EQ(l.residual, r.residual);
    for (std::size_t point = 0; point < r.failed.size(); ++point) ASSERT_EQ(l.points[point], r.points[point]) << point;
}
void expect_same_pairs(const ContactPairList& l, const ContactPairList& r) {
    EXPECT_EQ(l.debonded, r.debonded);
    EXPECT_EQ(l.released, r.released);
    EXPECT_EQ(l.pairs, r.pairs);
    EXPECT_TRUE(have_same_numbers(l.contacts, r.contacts));
    EXPECT_TRUE(same_bytes(l.forces, r.forces));
    EXPECT_EQ(l.watched, r.watched);
    EXPECT_EQ(l.active.pair, r.active.pair);
    EXPECT_EQ(l.active.count, r.active.count);
}

TEST(WholeState, OfARankAloneIsItsOwn) {
    const SmallRun& run = crushed_alone(0);
    EXPECT_EQ(&WholeState(run.assemblage, run.state).state(), &run.state);
}

TEST(WholeState, OfRanksHasTheBytesOfOneAlone) {
    for_some_ranks([](std::size_t row, int n) {
        const State& alone = crushed_alone(row).state;
        ASSERT_GT(test::n_active_contacts(alone.contact_pairs), 20);
        on_thread_ranks(n, [&](const Ranks& ranks) {
            const SmallRun run = crushed_run(crushes()[row], ranks);
            const WholeState whole(run.assemblage, run.state);
            if (!ranks.is_first()) return;
            const State& s = whole.state();
            for (const auto of_nodes : {&State::displacement, &State::velocity, &State::last_force}) {
                EXPECT_TRUE(same_bytes(s.*of_nodes, alone.*of_nodes));
            }
            expect_same_points(s, alone);
            expect_same_pairs(s.contact_pairs, alone.contact_pairs);
            EXPECT_TRUE(have_same_numbers(s.platen_points, alone.platen_points));
            EXPECT_TRUE(same_bytes(s.node_sums, alone.node_sums));
            EXPECT_TRUE(same_bytes(s.contact_sums, alone.contact_sums));
            EXPECT_TRUE(same_bytes(s.clusters.sums, alone.clusters.sums));
            EXPECT_EQ(s.clusters.near_platen, alone.clusters.near_platen);
            EXPECT_TRUE(same_bytes(s.contact_pairs.friction, alone.contact_pairs.friction));
            EXPECT_TRUE(same_bytes(s.contact_pairs.cluster_load, alone.contact_pairs.cluster_load));
            EXPECT_TRUE(same_bytes(s.contact_pairs.displacement_at_search, alone.contact_pairs.displacement_at_search));
            EXPECT_TRUE(same_bytes(s.damping_load.mean_displacement, alone.damping_load.mean_displacement));
            EXPECT_EQ(s.contact_pairs.next_update, alone.contact_pairs.next_update);
            EXPECT_EQ(s.time, alone.time);
        });
    });
}

TEST(WholeState, TakenApartGivesEachRankItsPairs) {
    for_some_ranks([](std::size_t row, int n) {
        on_thread_ranks(n, [&](const Ranks& ranks) {
            const SmallRun run = crushed_run(crushes()[row], ranks);
            const ContactPairList& own = run.state.contact_pairs;
            ContactPairList kept = crushed_alone(row).state.contact_pairs;
            keep_own_pairs(run.assemblage, kept);
            EXPECT_LT(kept.pairs.size(), crushed_alone(row).state.contact_pairs.pairs.size());
            EXPECT_EQ(kept.pairs, own.pairs);
            EXPECT_TRUE(have_same_numbers(kept.contacts, own.contacts));
            EXPECT_TRUE(same_bytes(kept.forces, own.forces));
            EXPECT_EQ(bounds_of(kept.groups), bounds_of(own.groups));
            EXPECT_EQ(kept.watched, own.watched);
            EXPECT_EQ(bounds_of(kept.watched_groups), bounds_of(own.watched_groups));
            EXPECT_EQ(bounds_of(kept.chunks), bounds_of(own.chunks));
            EXPECT_EQ(kept.node_chunks, own.node_chunks);
            EXPECT_EQ(kept.active.count, own.active.count);
            EXPECT_EQ(active_pairs(kept), active_pairs(own));
        });
    });
    ContactPairList kept = crushed_alone(0).state.contact_pairs;
    keep_own_pairs(crushed_alone(0).assemblage, kept);
    expect_same_pairs(kept, crushed_alone(0).state.contact_pairs);
}

/// Whether the values of a chunk are the same in two arrays with `per_chunk` values for each.
template <class Value>
bool same_in_chunk(std::int32_t chunk, std::size_t per_chunk, const std::vector<Value>& l, const std::vector<Value>& r) {
    const std::size_t begin = std::min(per_chunk * static_cast<std::size_t>(chunk), l.size());
    const std::size_t end = std::min(begin + per_chunk, l.size());
    return same_bytes(std::vector<Value>(l.begin() + begin, l.begin() + end),
                      std::vector<Value>(r.begin() + begin, r.begin() + end));
}

// What lies on a cut is evaluated by every rank that owns a node of it.
TEST(WholeState, CopiesOnSeveralRanksAreTheSame) {
    constexpr std::size_t points = 2UL * contacts_per_chunk;
    for_some_ranks([](std::size_t row, int n) {
        const State& alone = crushed_alone(row).state;
        const ContactPairList& all = alone.contact_pairs;
        std::vector<int> n_evaluating(crushed_alone(row).assemblage.contact_chunks.size(), 0);
        std::vector<int> n_having(all.pairs.size(), 0);
        on_thread_ranks(n, [&](const Ranks& ranks) {
            const SmallRun run = crushed_run(crushes()[row], ranks);
            const State& s = run.state;
            for_each_evaluated(run.assemblage.part.evaluated_contacts, [&](std::int32_t chunk) {
                ++n_evaluating[chunk];
                for (const auto of_points : {&State::opening, &State::sliding, &State::integrity, &State::slip}) {
                    EXPECT_TRUE(same_in_chunk(chunk, points, s.*of_points, alone.*of_points)) << chunk;
                }
                EXPECT_TRUE(same_in_chunk(chunk, points, s.failed, alone.failed)) << chunk;
                EXPECT_TRUE(same_in_chunk(chunk, points, s.next_mark, alone.next_mark)) << chunk;
                EXPECT_TRUE(same_in_chunk(chunk, slot_stride, s.contact_force, alone.contact_force)) << chunk;
                EXPECT_TRUE(same_in_chunk(chunk, 1, s.contact_sums, alone.contact_sums)) << chunk;
            });
            for (std::size_t i = 0; i < s.contact_pairs.pairs.size(); ++i) {
                const auto at = std::lower_bound(all.pairs.begin(), all.pairs.end(), s.contact_pairs.pairs[i]);
                ASSERT_TRUE(at != all.pairs.end() && *at == s.contact_pairs.pairs[i]);
                const auto k = static_cast<std::size_t>(at - all.pairs.begin());
                n_having[k] += all.contacts[k].active ? 1 : 0;
                EXPECT_EQ(numbers_of(s.contact_pairs.contacts[i]), numbers_of(all.contacts[k]));
                for (std::size_t f = 0; f < 3; ++f) {
                    EXPECT_EQ(s.contact_pairs.forces[3 * i + f].x, all.forces[3 * k + f].x);
                    EXPECT_EQ(s.contact_pairs.forces[3 * i + f].y, all.forces[3 * k + f].y);
                }
            }
            for (const std::int32_t node : run.assemblage.part.ghosts) {
                EXPECT_EQ(s.displacement[node].x, alone.displacement[node].x);
                EXPECT_EQ(s.displacement[node].y, alone.displacement[node].y);
            }
        });
        EXPECT_GT(std::count_if(n_evaluating.begin(), n_evaluating.end(), [](int ranks) { return ranks > 1; }), 0);
        EXPECT_GT(std::count_if(n_having.begin(), n_having.end(), [](int ranks) { return ranks > 1; }), 3);
    });
}

}  // namespace
}  // namespace graincrack
