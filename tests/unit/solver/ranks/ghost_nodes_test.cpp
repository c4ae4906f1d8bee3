// Numbers of nodes go from their owners to all that read them, and nowhere else.
#include "solver/ranks/ghost_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/thread_ranks.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t n_ghost_nodes = 40;

/// Ten nodes for each rank but the last, which has the others.
int owner_of_ghost(int n_ranks, std::int32_t node) { return std::min(node / 10, n_ranks - 1); }

/// Nodes that a rank reads: none that it owns; of rank 2 nothing at all.
std::vector<std::int32_t> ghosts_of(int n_ranks, int rank) {
    std::vector<std::int32_t> ghosts;
    for (std::int32_t node = 0; node < n_ghost_nodes && rank != 2; ++node) {
        if (owner_of_ghost(n_ranks, node) != rank && (node * 7 + rank) % 3 == 0) ghosts.push_back(node);
    }
    return ghosts;
}

double number_of(std::int32_t node, int round, std::size_t component) {
    return 1000.0 * round + 10.0 * node + static_cast<double>(component);
}

TEST(GhostNodes, AreThoseOfTheirOwners) {
    using Motion = std::array<double, GhostNodes::n_motion>;
    for (int n = 2; n <= 4; ++n) {
        test::on_thread_ranks(n, [n](const Ranks& ranks) {
            const std::vector<std::int32_t> ghosts = ghosts_of(n, ranks.rank());
            const auto is_own = [&](std::int32_t node) { return owner_of_ghost(n, node) == ranks.rank(); };
            const GhostNodes nodes(ranks, ghosts, [n](std::int32_t node) { return owner_of_ghost(n, node); });
            EXPECT_EQ(nodes.n_ghosts(), ghosts.size());
            for (int round = 0; round < 3; ++round) {
                std::vector<std::int32_t> set;
                nodes.start([&](std::int32_t node) {
                    EXPECT_TRUE(is_own(node));
                    Motion motion{};
                    for (std::size_t k = 0; k < motion.size(); ++k) motion[k] = number_of(node, round, k);
                    return motion;
                });
                nodes.finish([&](std::int32_t node, const double* numbers) {
                    set.push_back(node);
                    for (std::size_t k = 0; k < GhostNodes::n_motion; ++k) EXPECT_EQ(numbers[k], number_of(node, round, k));
                });
                EXPECT_EQ(set, ghosts);  // each once; neighbours come in the order of their nodes
                set.clear();
                nodes.update([&](std::int32_t node) { return number_of(node, round, 5); },
                             [&](std::int32_t node, double number) {
                                 set.push_back(node);
                                 EXPECT_EQ(number, number_of(node, round, 5));
                             });
                EXPECT_EQ(set, ghosts);
            }
        });
    }
}

TEST(GhostNodes, HaveNeighboursThatReadOrAreRead) {
    test::on_thread_ranks(4, [](const Ranks& ranks) {
        // Rank 0 reads of rank 1; rank 3 neither reads nor is read.
        const std::vector<std::vector<std::int32_t>> ghosts{{12}, {}, {13, 15}, {}};
        const GhostNodes nodes(ranks, ghosts[static_cast<std::size_t>(ranks.rank())],
                               [](std::int32_t node) { return owner_of_ghost(4, node); });
        EXPECT_EQ(nodes.n_neighbours(), (std::array<std::size_t, 4>{1, 2, 1, 0})[static_cast<std::size_t>(ranks.rank())]);
        double received = 0;
        nodes.update([](std::int32_t node) { return node; }, [&](std::int32_t /*node*/, double number) { received += number; });
        EXPECT_EQ(received, (std::array{12.0, 0.0, 28.0, 0.0})[static_cast<std::size_t>(ranks.rank())]);
    });
}

}  // namespace
}  // namespace graincrack
