// The parts of ranks: together they are the whole, each has what it needs, and sums do not depend on them.
#include "solver/model/part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "tests/support/phases.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/thread_ranks.hpp"

namespace graincrack {
namespace {

using Chunks = std::vector<std::int32_t>;

/// What a part is made of.
struct WholeSpecimen {
    std::string name;
    Assemblage assemblage;
    PrescribedConditions prescribed;
};
WholeSpecimen whole_specimen(const std::string& name, test::SmallRun run) {
    return {name, std::move(run.assemblage), std::move(run.boundary.prescribed)};
}

/// Chunks of one item each, in no order: all that a part asks of an assemblage. Elements and contacts have nodes of anywhere.
WholeSpecimen scattered_chunks(std::int32_t n_nodes, std::int32_t n_elements, std::int32_t n_contacts) {
    WholeSpecimen whole;
    whole.name = "scattered chunks";
    Assemblage& a = whole.assemblage;
    a.position.resize(static_cast<std::size_t>(n_nodes));
    for (std::int32_t i = 0; i < n_nodes; ++i) a.node_chunks.push_back({{i, i + 1}, {i, i + 1}, {i, i + 1}});
    for (std::int32_t e = 0; e < n_elements; ++e) {
        const std::int32_t first = (e * 7919) % (n_nodes - 2);
        a.element_nodes.push_back({first, first + 1, first + 2});
        a.element_chunks.push_back({e, e + 1});
    }
    for (std::int32_t c = 0; c < n_contacts; ++c) {
        const std::int32_t first = (c * 104729) % (n_nodes - 1);
        ContactGeometry contact{};
        contact.nodes = {first, first + 1, (first + 17) % n_nodes, (first + 18) % n_nodes};
        a.contacts.push_back(contact);
        a.contact_chunks.push_back({{c, c + 1}, 0});
    }
    return whole;
}

/// Grains in no order, classes of contacts, large grains, loaded edges, and a specimen of a single chunk.
const std::vector<WholeSpecimen>& whole_specimens() {
    static const std::vector<WholeSpecimen> specimens = [] {
        std::vector<WholeSpecimen> all;
        all.push_back(whole_specimen("grid", {test::jittered_grid(10, 20, 0.04, 0.08, 0.25), test::augig_law()}));
        all.push_back(whole_specimen(
            "phases", test::varied_phases(test::jittered_grid(8, 16, 0.04, 0.08, 0.25)).run(LawVariant::consistent)));
        test::SmallRun pressed(test::jittered_grid(12, 12, 0.04, 0.04, 0.25), test::augig_law());
        pressed.press_on({BoundaryPart::left, BoundaryPart::right, BoundaryPart::top, BoundaryPart::bottom}, 0.5);
        all.push_back(whole_specimen("pressed", std::move(pressed)));
        all.push_back(whole_specimen(
            "blocks",
            {test::crossed_blocks(12, 12, 0.04, 0.04, [](int i, int j) { return i / 3 + 4 * (j / 3); }), test::augig_law()}));
        all.push_back(whole_specimen(
            "joint", {test::jointed_rectangle(12, 5, 0.04, 0.08, 0.3, test::Blocks::of_grains), test::augig_law()}));
        all.push_back(whole_specimen("few grains", {test::jittered_grid(2, 2, 0.04, 0.04, 0.25), test::augig_law()}));
        all.push_back(scattered_chunks(300, 200, 250));
        return all;
    }();
    return specimens;
}

/// Parts of a specimen by rank. They are read after their ranks have ended.
std::vector<Part> parts_of(const WholeSpecimen& whole, int n) {
    std::vector<Part> parts(static_cast<std::size_t>(n));
    test::on_thread_ranks(n, [&](const Ranks& ranks) {
        parts[static_cast<std::size_t>(ranks.rank())] = make_part(whole.assemblage, whole.prescribed, ranks);
    });
    return parts;
}
/// The same of every specimen and of 1 to 5 ranks. \param check (whole, parts)
template <class Check>
void for_all_parts(const Check& check) {
    for (const WholeSpecimen& whole : whole_specimens()) {
        for (int n = 1; n <= 5; ++n) {
            SCOPED_TRACE(whole.name + " on " + std::to_string(n));
            check(whole, parts_of(whole, n));
        }
    }
}
Range nodes_of_rank(const Part& part, std::size_t rank) { return {part.first_node[rank], part.first_node[rank + 1]}; }
bool is_in(Range nodes, std::int32_t node) { return node >= nodes.begin && node < nodes.end; }

/// Calls `act` with the nodes of each element or contact of a chunk.
template <class Act>
void for_nodes_of_elements(const Assemblage& a, std::int32_t chunk, const Act& act) {
    for (std::int32_t e = a.element_chunks[chunk].begin; e < a.element_chunks[chunk].end; ++e) act(a.element_nodes[e]);
}
template <class Act>
void for_nodes_of_contacts(const Assemblage& a, std::int32_t chunk, const Act& act) {
    const Range contacts = a.contact_chunks[chunk].contacts;
    for (std::int32_t c = contacts.begin; c < contacts.end; ++c) act(a.contacts[c].nodes);
}

Chunks all_up_to(std::int32_t count) {
    Chunks all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

TEST(Part, EveryChunkHasOneOwner) {
    for_all_parts([](const WholeSpecimen& whole, const std::vector<Part>& parts) {
        for (const auto share : {&Part::nodes, &Part::elements, &Part::contacts}) {
            Chunks of_all;
            Chunks sums_of_all;
            for (std::size_t rank = 0; rank < parts.size(); ++rank) {
                const ChunkShare& own = parts[rank].*share;
                EXPECT_EQ(own.owner, (parts[0].*share).owner);
                EXPECT_TRUE(std::is_sorted(own.own.begin(), own.own.end()));
                for (const std::int32_t chunk : own.own) EXPECT_EQ(own.owner_of(chunk), static_cast<int>(rank));
                EXPECT_EQ((parts[0].*share).n_sums_of[rank], static_cast<std::int32_t>(own.own_sums.size()));
                of_all.insert(of_all.end(), own.own.begin(), own.own.end());
                sums_of_all.insert(sums_of_all.end(), own.own_sums.begin(), own.own_sums.end());
            }
            std::sort(of_all.begin(), of_all.end());
            std::sort(sums_of_all.begin(), sums_of_all.end());
            EXPECT_EQ(of_all, all_up_to((parts[0].*share).count));
            EXPECT_EQ(sums_of_all, all_up_to((parts[0].*share).n_sums()));
        }
        EXPECT_EQ(parts[0].nodes.count, static_cast<std::int32_t>(whole.assemblage.node_chunks.size()));
        EXPECT_EQ(parts[0].elements.count, static_cast<std::int32_t>(whole.assemblage.element_chunks.size()));
        EXPECT_EQ(parts[0].contacts.count, static_cast<std::int32_t>(whole.assemblage.contact_chunks.size()));
    });
}

TEST(Part, NodesOfARankAreThoseOfItsChunks) {
    for_all_parts([](const WholeSpecimen& whole, const std::vector<Part>& parts) {
        const Assemblage& a = whole.assemblage;
        EXPECT_EQ(parts[0].first_node.size(), parts.size() + 1);
        EXPECT_EQ(parts[0].first_node.front(), 0);
        EXPECT_EQ(parts[0].first_node.back(), a.n_nodes());
        EXPECT_TRUE(std::is_sorted(parts[0].first_node.begin(), parts[0].first_node.end()));
        for (const Part& part : parts) EXPECT_EQ(part.first_node, parts[0].first_node);
        for (std::int32_t chunk = 0; chunk < parts[0].nodes.count; ++chunk) {
            for (std::int32_t i = a.node_chunks[chunk].nodes.begin; i < a.node_chunks[chunk].nodes.end; ++i) {
                EXPECT_EQ(parts[0].owner_of_node(i), parts[0].nodes.owner_of(chunk));
                EXPECT_TRUE(is_in(nodes_of_rank(parts[0], static_cast<std::size_t>(parts[0].owner_of_node(i))), i));
            }
        }
    });
}

/// Whether a rank evaluates what has an own node, without ghosts the inner chunks only. \param needed gets the other nodes
template <class ForNodes>
void expect_evaluated(const EvaluatedChunks& chunks, std::int32_t count, Range own, const ForNodes& for_nodes,
                      std::set<std::int32_t>& needed) {
    EXPECT_TRUE(std::is_sorted(chunks.inner.begin(), chunks.inner.end()));
    EXPECT_TRUE(std::is_sorted(chunks.outer.begin(), chunks.outer.end()));
    const std::set<std::int32_t> inner(chunks.inner.begin(), chunks.inner.end());
    const std::set<std::int32_t> outer(chunks.outer.begin(), chunks.outer.end());
    EXPECT_EQ(inner.size() + outer.size(), chunks.inner.size() + chunks.outer.size());
    for (std::int32_t chunk = 0; chunk < count; ++chunk) {
        bool has_own = false;
        std::set<std::int32_t> others;
        for_nodes(chunk, [&](const auto& nodes) {
            for (const std::int32_t node : nodes) {
                has_own = has_own || is_in(own, node);
                if (!is_in(own, node)) others.insert(node);
            }
        });
        if (has_own) {
            EXPECT_EQ(inner.count(chunk), others.empty() ? 1U : 0U) << chunk;
            EXPECT_EQ(outer.count(chunk), others.empty() ? 0U : 1U) << chunk;
        }
        if (outer.count(chunk) > 0) needed.insert(others.begin(), others.end());
    }
}

TEST(Part, EvaluatesWhatHasAnOwnNodeAndKnowsItsOtherNodes) {
    std::size_t n_ghosts = 0;
    for_all_parts([&](const WholeSpecimen& whole, const std::vector<Part>& parts) {
        const Assemblage& a = whole.assemblage;
        for (std::size_t rank = 0; rank < parts.size(); ++rank) {
            const Part& part = parts[rank];
            const Range own = nodes_of_rank(part, rank);
            std::set<std::int32_t> needed;
            expect_evaluated(
                part.evaluated_elements, part.elements.count, own,
                [&](std::int32_t chunk, const auto& act) { for_nodes_of_elements(a, chunk, act); }, needed);
            expect_evaluated(
                part.evaluated_contacts, part.contacts.count, own,
                [&](std::int32_t chunk, const auto& act) { for_nodes_of_contacts(a, chunk, act); }, needed);
            // Sums over chunks of a kind need all that the owner has.
            Chunks evaluated;
            for_each_evaluated(part.evaluated_elements, [&](std::int32_t chunk) { evaluated.push_back(chunk); });
            std::sort(evaluated.begin(), evaluated.end());
            EXPECT_TRUE(std::includes(evaluated.begin(), evaluated.end(), part.elements.own.begin(), part.elements.own.end()));
            evaluated.clear();
            for_each_evaluated(part.evaluated_contacts, [&](std::int32_t chunk) { evaluated.push_back(chunk); });
            std::sort(evaluated.begin(), evaluated.end());
            EXPECT_TRUE(std::includes(evaluated.begin(), evaluated.end(), part.contacts.own.begin(), part.contacts.own.end()));
            for (std::int32_t chunk = 0; chunk < part.contacts.count; ++chunk) {
                EXPECT_EQ(part.evaluates_contacts[chunk], std::binary_search(evaluated.begin(), evaluated.end(), chunk) ? 1 : 0);
            }
            // Loaded edges are those of the chunk of their first node.
            const std::set<std::int32_t> loaded(part.loaded_chunks.begin(), part.loaded_chunks.end());
            EXPECT_EQ(loaded.size(), part.loaded_chunks.size());
            for (const std::int32_t chunk : part.nodes.own) EXPECT_EQ(loaded.count(chunk), 1U);
            for (std::int32_t chunk = 0; chunk < part.nodes.count && !whole.prescribed.edges.empty(); ++chunk) {
                for (std::int32_t i = whole.prescribed.edges_of_chunk[chunk].begin;
                     i < whole.prescribed.edges_of_chunk[chunk].end; ++i) {
                    const auto [first, second] = whole.prescribed.edges[i].nodes;
                    EXPECT_TRUE(loaded.count(chunk) == 1 || !(is_in(own, first) || is_in(own, second)));
                    if (loaded.count(chunk) == 0) continue;
                    if (!is_in(own, first)) needed.insert(first);
                    if (!is_in(own, second)) needed.insert(second);
                }
            }
            EXPECT_EQ(part.ghosts, Chunks(needed.begin(), needed.end()));
            n_ghosts += part.ghosts.size();
        }
    });
    EXPECT_GT(n_ghosts, 1000U);
}

// A loaded edge with its ends on two ranks is one that both find the load of.
TEST(Part, LoadsEdgesOnACutOnBothSides) {
    std::size_t n_cut = 0;
    for (const WholeSpecimen& whole : whole_specimens()) {
        const std::vector<Part> parts = parts_of(whole, 5);
        for (const LoadedEdge& edge : whole.prescribed.edges) {
            const int first = parts[0].owner_of_node(edge.nodes[0]);
            const int second = parts[0].owner_of_node(edge.nodes[1]);
            if (first == second) continue;
            ++n_cut;
            const std::int32_t chunk = chunk_of_node(whole.assemblage, edge.nodes[0]);
            for (const int rank : {first, second}) {
                const Chunks& loaded = parts[static_cast<std::size_t>(rank)].loaded_chunks;
                EXPECT_EQ(std::count(loaded.begin(), loaded.end(), chunk), 1);
            }
        }
    }
    EXPECT_GT(n_cut, 0U);
}

// The grains of a grid are all alike.
TEST(Part, SharesTheWorkEvenly) {
    const WholeSpecimen& grid = whole_specimens().front();
    for (int n = 2; n <= 4; ++n) {
        const std::vector<Part> parts = parts_of(grid, n);
        for (std::size_t rank = 0; rank < parts.size(); ++rank) {
            const double share = static_cast<double>(nodes_of_rank(parts[rank], rank).size()) / grid.assemblage.n_nodes();
            EXPECT_NEAR(share, 1.0 / n, 1.2 / static_cast<double>(grid.assemblage.node_chunks.size())) << n;
        }
    }
}

TEST(Part, OfMoreRanksThanChunksLeavesSomeWithNothing) {
    const std::vector<Part> parts =
        parts_of(whole_specimen("one cell", {test::jittered_grid(1, 1, 1, 1, 0), test::augig_law()}), 5);
    EXPECT_EQ(parts[0].nodes.count, 1);
    EXPECT_EQ(std::count_if(parts.begin(), parts.end(), [](const Part& part) { return part.nodes.own.empty(); }), 4);
    for (std::size_t rank = 0; rank < parts.size(); ++rank) {
        const Part& part = parts[rank];
        if (!part.nodes.own.empty()) continue;
        EXPECT_EQ(nodes_of_rank(part, rank).size(), 0);
        EXPECT_TRUE(part.ghosts.empty());
        EXPECT_TRUE(part.evaluated_elements.outer.empty() && part.evaluated_elements.inner.empty());
    }
}

// --- sums ------------------------------------------------------------------------------------------------------------------

/// A number that rounds otherwise in any other order of the sum.
double number_of_chunk(std::int32_t chunk) { return 1.0 / (1 + chunk) + (chunk % 3 - 1) * 1e3 / (1 + chunk % 7); }

/// Sums of each kind of chunks on one rank of `n`. \param digits gets their bytes on each rank
std::set<std::string> bytes_of_sums(const WholeSpecimen& whole, int n) {
    std::set<std::string> found;
    test::on_thread_ranks(n, [&](const Ranks& ranks) {
        const Part part = make_part(whole.assemblage, whole.prescribed, ranks);
        std::string bytes;
        for (const ChunkShare* share : {&part.nodes, &part.elements, &part.contacts}) {
            const double sum = sum_over_chunks(part, *share, number_of_chunk);
            bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
        }
        found.insert(bytes);
    });
    return found;
}

TEST(Part, SumsHaveTheSameBytesOnAnyNumberOfRanks) {
    // The last has more chunks of each kind than ranks tell each other sums: 3 or 4 chunks a sum, and fewer in the last.
    std::vector<WholeSpecimen> all = whole_specimens();
    all.push_back(scattered_chunks(9001, 13001, 12301));
    for (const WholeSpecimen& whole : all) {
        const std::set<std::string> one = bytes_of_sums(whole, 1);
        ASSERT_EQ(one.size(), 1U);
        for (int n = 2; n <= 5; ++n) EXPECT_EQ(bytes_of_sums(whole, n), one) << whole.name << " on " << n;
    }
}

TEST(Part, SumsOfManyChunksAreMadeOfSumsOfSome) {
    const WholeSpecimen whole = scattered_chunks(9001, 13001, 4096);
    for (const Part& part : parts_of(whole, 3)) {
        EXPECT_EQ(part.nodes.chunks_per_sum, 3);
        EXPECT_EQ(part.elements.chunks_per_sum, 4);
        EXPECT_EQ(part.contacts.chunks_per_sum, 1);
        for (const ChunkShare* share : {&part.nodes, &part.elements, &part.contacts}) {
            EXPECT_LE(share->n_sums(), 4096);
            EXPECT_EQ(share->chunks_of_sum(share->n_sums() - 1).end, share->count);
        }
    }
    const double expected = [&] {
        double total = 0;
        for (std::int32_t begin = 0; begin < 9001; begin += 3) {
            double sum = 0;
            for (std::int32_t chunk = begin; chunk < std::min(begin + 3, 9001); ++chunk) sum += number_of_chunk(chunk);
            total += sum;
        }
        return total;
    }();
    const Part alone = parts_of(whole, 1).front();
    EXPECT_EQ(sum_over_chunks(whole_part(whole.assemblage), alone.nodes, number_of_chunk), expected);
}

TEST(Part, FindsValuesAtNodesOfAnyRank) {
    const WholeSpecimen& whole = whole_specimens().front();
    const std::int32_t n_nodes = whole.assemblage.n_nodes();
    const std::vector<std::int32_t> nodes{n_nodes - 1, 0, n_nodes / 2, 3, n_nodes / 3, 0};
    for (int n = 1; n <= 5; ++n) {
        test::on_thread_ranks(n, [&](const Ranks& ranks) {
            const Part part = make_part(whole.assemblage, whole.prescribed, ranks);
            std::vector<double> values(static_cast<std::size_t>(n_nodes), -1);
            for (std::int32_t i = part.own_nodes().begin; i < part.own_nodes().end; ++i) values[i] = 2.0 * i;
            std::vector<double> expected;
            for (const std::int32_t node : nodes) expected.push_back(2.0 * node);
            EXPECT_EQ(values_at(part, nodes, values), expected) << n;
        });
    }
}

}  // namespace
}  // namespace graincrack
