// Each rank finds the pairs that act on its own nodes, and knows what it needs of the nodes and contacts of others.
#include "solver/detection/pair_exchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "share/base/error.hpp"
#include "solver/detection/pair_search.hpp"
#include "solver/detection/stable_area.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/thread_ranks.hpp"

namespace graincrack::test {
namespace {

using Pairs = std::vector<CandidatePair>;

SmallRun bonded_grains() { return {jittered_grid(10, 20, 0.04, 0.08, 0.25), augig_law()}; }

/// Scatter of the grains, in mean lengths of edges: they have hardly moved, or are anywhere.
constexpr double near_their_places = 0.1;
constexpr double far_from_their_places = 3;

Vector2 shift_of_grain(const SmallRun& run, std::int32_t grain, double scatter) {
    const double size = scatter * run.assemblage.surface.mean_length;
    return {size * ((grain * 37) % 41 / 20.0 - 1), size * ((grain * 53) % 43 / 21.0 - 1)};
}

/// Grains that nothing links, scattered. The displacements of other ranks' nodes are no numbers.
SmallRun loose_grains(const Ranks& ranks, double scatter = near_their_places) {
    SmallRun run = bonded_grains();
    loosen(run);
    run.share(ranks);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::int32_t i = 0; i < run.assemblage.n_nodes(); ++i) {
        run.state.displacement[i] = Vector2{nan, nan};
        if (run.assemblage.part.owns(i)) {
            run.state.displacement[i] = shift_of_grain(run, run.assemblage.surface.grain_of_node[i], scatter);
        }
    }
    return run;
}

double margin_of(const SmallRun& run) { return 0.04 * run.assemblage.surface.mean_length; }

/// All pairs of nodes of which one acts on an own node.
Pairs pairs_near_own_nodes(const SmallRun& run, const Pairs& all) {
    const Part& part = run.assemblage.part;
    const std::vector<SurfaceEdge>& edges = run.assemblage.surface.edges;
    std::set<std::int32_t> nodes;
    for (const CandidatePair& pair : all) {
        const auto [first, second] = edges[pair.edge].nodes;
        if (part.owns(pair.node) || part.owns(first) || part.owns(second)) nodes.insert(pair.node);
    }
    Pairs near;
    std::copy_if(all.begin(), all.end(), std::back_inserter(near),
                 [&](const CandidatePair& p) { return nodes.count(p.node) > 0; });
    return near;
}

TEST(PairExchange, ExposesFreeFacesAndWhatIsBesideALooseContact) {
    SmallRun run = bonded_grains();
    const std::vector<SurfaceEdge>& edges = run.assemblage.surface.edges;
    std::set<std::int32_t> exposed;
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(edges.size()); ++e) {
        if (edges[e].contact < 0) exposed.insert(e);
    }
    const auto found = [&] {
        const std::vector<std::int32_t> list = find_exposed_edges(run.assemblage, run.state.contact_pairs);
        EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
        return std::set<std::int32_t>(list.begin(), list.end());
    };
    EXPECT_EQ(found(), exposed);
    const std::int32_t loose = run.assemblage.contact_of_specimen[200];
    run.state.contact_pairs.debonded[2 * loose + 1] = 1;
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(edges.size()); ++e) {
        if (edges[e].contact == loose) exposed.insert({e, edges[e].previous, edges[e].next});
    }
    EXPECT_EQ(found(), exposed);
}

TEST(PairExchange, FindsThePairsThatActOnTheNodesOfARank) {
    for (const auto& [scatter, margins] :
         {std::pair(near_their_places, 1), std::pair(near_their_places, 8), std::pair(far_from_their_places, 1)}) {
        SmallRun alone = loose_grains(Ranks::alone(), scatter);
        const double margin = margins * margin_of(alone);
        const Pairs all = find_pairs(alone.assemblage, margin, alone.state);
        ASSERT_GT(all.size(), 500U);
        for (int n = 2; n <= 5; ++n) {
            on_thread_ranks(n, [&, scatter = scatter](const Ranks& ranks) {
                SmallRun run = loose_grains(ranks, scatter);
                const Pairs expected = pairs_near_own_nodes(run, all);
                EXPECT_LT(expected.size(), all.size());
                EXPECT_EQ(find_pairs(run.assemblage, margin, run.state), expected) << n;
            });
        }
    }
}

/// The pairs of a rank, without contacts.
SmallRun grains_with_pairs(const Ranks& ranks) {
    SmallRun run = loose_grains(ranks);
    ContactPairList& list = run.state.contact_pairs;
    list.pairs = find_pairs(run.assemblage, margin_of(run), run.state);
    list.contacts.resize(list.pairs.size());
    return run;
}

/// Nodes of other ranks with several pairs.
std::vector<std::int32_t> other_nodes_with_pairs(const SmallRun& run) {
    std::vector<std::int32_t> nodes;
    const Pairs& pairs = run.state.contact_pairs.pairs;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        if (pairs[i].node == pairs[i - 1].node && !run.assemblage.part.owns(pairs[i].node)) nodes.push_back(pairs[i].node);
    }
    return nodes;
}

TEST(PairExchange, RefusesPairsThatAnOwnerAndAReaderDoNotShare) {
    Refusals refused;
    for (const int lacking : {0, 1}) {
        refused.add<NumericalError>("rank " + std::to_string(lacking) + " lacks a pair", [lacking] {
            on_thread_ranks(2, [lacking](const Ranks& ranks) {
                SmallRun run = grains_with_pairs(ranks);
                ContactPairList& list = run.state.contact_pairs;
                const std::int32_t node = ranks.gather_all(other_nodes_with_pairs(run))[1].front();  // owned by rank 0
                const auto at = std::lower_bound(list.pairs.begin(), list.pairs.end(), CandidatePair{node, 0});
                ASSERT_EQ(at->node, node);
                if (ranks.rank() == lacking) {
                    list.contacts.erase(list.contacts.begin() + (at - list.pairs.begin()));
                    list.pairs.erase(at);
                }
                take_contacts_of_owners(run.assemblage, list);
            });
        });
    }
    expect_golden(refused.text());
}

/// Areas of the pairs of a rank, as contacts of long and as new ones, after they were limited.
struct LimitedAreas {
    Pairs pairs;
    std::vector<double> area, overlap, new_area;
};
LimitedAreas limited_areas(const Ranks& ranks) {
    SmallRun run = loose_grains(ranks, far_from_their_places);
    run.parameters.mass_scaling = make_mass_scaling(run.assemblage, 60);
    run.parameters.time_step *= 4;  // so that clusters have too many contacts
    ContactPairList& list = run.state.contact_pairs;
    list.pairs = find_pairs(run.assemblage, margin_of(run), run.state);
    list.forces.resize(3 * list.pairs.size());
    std::vector<NewContact> contacts;
    for (const CandidatePair& pair : list.pairs) {
        const double half = 0.5 * run.assemblage.surface.tributary[pair.node];
        const NodeEdgeContact contact{.active = pair.node % 2 == 0, .area = half, .overlap = 1e-6};
        list.contacts.push_back(contact);
        if (!contact.active) contacts.push_back({static_cast<std::int32_t>(list.contacts.size()) - 1, {}, contact.area});
    }
    find_ghosts(run.assemblage, run.state);
    limit_contact_areas(run.assemblage, run.parameters, run.state);
    limit_new_areas(run.assemblage, run.parameters, contacts, run.state);
    LimitedAreas areas;
    areas.pairs = list.pairs;
    std::size_t k = 0;
    for (const NodeEdgeContact& contact : list.contacts) {
        areas.area.push_back(contact.area);
        areas.overlap.push_back(contact.overlap);
        areas.new_area.push_back(contact.active ? -1 : contacts[k++].area);
    }
    return areas;
}

// What limits a contact on a cut are contacts of both sides, of which a rank knows a part.
TEST(PairExchange, LimitsAreasAsOnARankAlone) {
    const LimitedAreas alone = limited_areas(Ranks::alone());
    EXPECT_GT(std::count_if(alone.overlap.begin(), alone.overlap.end(), [](double overlap) { return overlap > 1e-6; }), 100);
    for (int n = 2; n <= 4; ++n) {
        on_thread_ranks(n, [&](const Ranks& ranks) {
            const LimitedAreas own = limited_areas(ranks);
            for (std::size_t i = 0; i < own.pairs.size(); ++i) {
                const auto at = std::lower_bound(alone.pairs.begin(), alone.pairs.end(), own.pairs[i]);
                ASSERT_TRUE(at != alone.pairs.end() && *at == own.pairs[i]);
                const auto k = static_cast<std::size_t>(at - alone.pairs.begin());
                EXPECT_EQ(own.area[i], alone.area[k]) << n;
                EXPECT_EQ(own.overlap[i], alone.overlap[k]) << n;
                EXPECT_EQ(own.new_area[i], alone.new_area[k]) << n;
            }
        });
    }
}

}  // namespace
}  // namespace graincrack::test
