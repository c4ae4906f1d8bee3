// Pairs of nodes and edges that are near each other, against all nodes and all edges.
#include "solver/detection/pair_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solver/detection/pair_geometry.hpp"
#include "solver/detection/pair_search.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

SmallRun grid() { return {jittered_grid(8, 8, 0.04, 0.04, 0.25), augig_law()}; }

/// A number for each grain, the same in each call.
std::vector<Vector2> vectors_of_grains(const SmallRun& run, double size) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> component(-size, size);
    std::vector<Vector2> of_grain(run.specimen.n_grains());
    for (Vector2& v : of_grain) v = {component(random), component(random)};
    return of_grain;
}

double distance(const SmallRun& run, const CandidatePair& pair) {
    const auto [first, second] = run.assemblage.surface.edges[pair.edge].nodes;
    const Vector2 p = position_of(run.assemblage, run.state, pair.node);
    const Vector2 q = position_of(run.assemblage, run.state, first);
    const Vector2 along = position_of(run.assemblage, run.state, second) - q;
    const double place = std::clamp(dot(p - q, along) / dot(along, along), 0.0, 1.0);
    return length(p - q - place * along);
}

/// Pairs of all nodes and edges of different grains that `holds`, ascending.
template <class Holds>
std::vector<CandidatePair> all_pairs(const SmallRun& run, const Holds& holds) {
    const GrainSurface& surface = run.assemblage.surface;
    std::vector<CandidatePair> pairs;
    for (std::int32_t node = 0; node < run.assemblage.n_nodes(); ++node) {
        for (std::int32_t edge = 0; edge < static_cast<std::int32_t>(surface.edges.size()); ++edge) {
            const bool is_own = surface.edges[edge].grain == surface.grain_of_node[node];
            if (!is_own && holds(CandidatePair{node, edge})) pairs.push_back({node, edge});
        }
    }
    return pairs;
}

// Grains that nothing links, scattered by up to a tenth of their size: pairs are near or not, whatever cells they lie in.
TEST(PairSearch, FindsThePairsNearerThanTheMarginAmongAll) {
    SmallRun run = grid();
    loosen(run);
    const double edge = run.assemblage.surface.mean_length;
    const std::vector<Vector2> shifts = vectors_of_grains(run, 0.1 * edge);
    for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
        run.state.displacement[i] = shifts[run.assemblage.surface.grain_of_node[i]];
    }
    for (const double margin : {0.01 * edge, 0.04 * edge, 0.3 * edge}) {
        const auto expected = all_pairs(run, [&](const CandidatePair& pair) { return distance(run, pair) <= margin; });
        EXPECT_GT(expected.size(), 10U);
        EXPECT_EQ(find_pairs(run.assemblage, margin, run.state), expected);
    }
}

// Where all is bonded, nothing is exposed but the outline, whose nodes are linked with all that is near.
TEST(PairSearch, FindsNoneInABondedSpecimen) {
    SmallRun run = grid();
    EXPECT_TRUE(find_pairs(run.assemblage, 0.04 * run.assemblage.surface.mean_length, run.state).empty());
}

// Loose grains fly about. Whatever node has come over an edge by the next update was in the list: none is missed in between.
TEST(PairList, HasWhatTouchesBeforeItsNextUpdate) {
    SmallRun run = grid();
    ContactPairList& list = run.state.contact_pairs;
    loosen(run);
    const std::vector<Vector2> velocities = vectors_of_grains(run, 10);
    for (std::size_t i = 0; i < run.state.velocity.size(); ++i) {
        run.state.velocity[i] = velocities[run.assemblage.surface.grain_of_node[i]];
    }
    run.begin();
    const double edge = run.assemblage.surface.mean_length;
    std::size_t touching = 0;
    for (int update = 0; update < 60; ++update) {
        update_pair_list(run.assemblage, run.parameters, run.state);
        EXPECT_TRUE(std::is_sorted(list.pairs.begin(), list.pairs.end()));
        EXPECT_TRUE(std::is_sorted(list.watched.begin(), list.watched.end()));
        EXPECT_LE(list.next_update - run.state.step, max_update_interval);
        while (run.state.step < list.next_update) run.steps(1);
        const auto over = all_pairs(run, [&](const CandidatePair& pair) {
            const PairGeometry g = pair_geometry(run.assemblage, run.state, pair);
            return g.depth > 0 && g.depth < 0.01 * edge && g.place > 0 && g.place < 1;
        });
        touching += over.size();
        EXPECT_TRUE(std::includes(list.pairs.begin(), list.pairs.end(), over.begin(), over.end())) << "update " << update;
    }
    EXPECT_GT(touching, 100U);
}

}  // namespace
}  // namespace graincrack::test
