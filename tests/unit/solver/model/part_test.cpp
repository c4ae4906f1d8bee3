// The parts of ranks share the work, and sums do not depend on them. That each rank has all it needs is tested by whole runs
// (tests/physics/thread_ranks_test.cpp).
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

namespace graincrack::test {
namespace {

/// What a part is made of.
struct WholeSpecimen {
    std::string name;
    Assemblage assemblage;
    PrescribedConditions prescribed;
};
WholeSpecimen whole_specimen(const std::string& name, SmallRun run) {
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

/// Grains in no order, classes of contacts, and a specimen of a single chunk.
const std::vector<WholeSpecimen>& whole_specimens() {
    static const std::vector<WholeSpecimen> specimens = [] {
        std::vector<WholeSpecimen> all;
        all.push_back(whole_specimen("grid", {jittered_grid(10, 20, 0.04, 0.08, 0.25), augig_law()}));
        all.push_back(
            whole_specimen("phases", varied_phases(jittered_grid(8, 16, 0.04, 0.08, 0.25)).run(LawVariant::consistent)));
        all.push_back(whole_specimen("few grains", {jittered_grid(2, 2, 0.04, 0.04, 0.25), augig_law()}));
        all.push_back(scattered_chunks(300, 200, 250));
        return all;
    }();
    return specimens;
}

/// Parts of a specimen by rank. They are read after their ranks have ended.
std::vector<Part> parts_of(const WholeSpecimen& whole, int n) {
    std::vector<Part> parts(static_cast<std::size_t>(n));
    on_thread_ranks(n, [&](const Ranks& ranks) { parts[ranks.rank()] = make_part(whole.assemblage, whole.prescribed, ranks); });
    return parts;
}
Range nodes_of_rank(const Part& part, std::size_t rank) { return {part.first_node[rank], part.first_node[rank + 1]}; }

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

TEST(Part, LeavesNothingToRanksBeyondItsChunks) {
    const std::vector<Part> parts = parts_of(whole_specimen("one cell", {jittered_grid(1, 1, 1, 1, 0), augig_law()}), 5);
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
    on_thread_ranks(n, [&](const Ranks& ranks) {
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

TEST(Part, SumsToTheSameBytesOnAnyNumberOfRanks) {
    // The last has more chunks of each kind than ranks tell each other sums: 3 or 4 chunks a sum, and fewer in the last.
    std::vector<WholeSpecimen> all = whole_specimens();
    all.push_back(scattered_chunks(9001, 13001, 12301));
    for (const WholeSpecimen& whole : all) {
        const std::set<std::string> one = bytes_of_sums(whole, 1);
        ASSERT_EQ(one.size(), 1U);
        for (int n = 2; n <= 5; ++n) EXPECT_EQ(bytes_of_sums(whole, n), one) << whole.name << " on " << n;
    }
}

TEST(Part, FindsValuesAtNodesOfAnyRank) {
    const WholeSpecimen& whole = whole_specimens().front();
    const std::int32_t n_nodes = whole.assemblage.n_nodes();
    const std::vector<std::int32_t> nodes{n_nodes - 1, 0, n_nodes / 2, 3, n_nodes / 3, 0};
    for (int n = 1; n <= 5; ++n) {
        on_thread_ranks(n, [&](const Ranks& ranks) {
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
}  // namespace graincrack::test
