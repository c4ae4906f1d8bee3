// The shares of threads cover the work of a step once, and are even.
#include "solver/step/step_shares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "solver/setup/request.hpp"
#include "tests/support/phases.hpp"

namespace graincrack::test {
namespace {

/// Grains of three phases under pressure between platens.
struct LoadedGrains {
    explicit LoadedGrains(int columns)
        : run(varied_phases(jittered_grid(columns, 2 * columns + 2, 0.04, 0.08, 0.25)).run(default_law)) {
        run.load_by({.confining_pressure = 8e6}, 0.7);
    }
    [[nodiscard]] StepShares shares(int n_threads) const {
        return share_step(run.assemblage, run.boundary, &run.state, n_threads);
    }
    SmallRun run;
};

TEST(StepShares, CoverAllOnce) {
    const LoadedGrains grains(9);
    for (const int n_threads : {1, 3, 40}) {
        std::vector<std::int32_t> nodes, loaded, contacts, elements;
        for (const StepShare& share : grains.shares(n_threads).of_threads) {
            nodes.insert(nodes.end(), share.nodes.begin(), share.nodes.end());
            loaded.insert(loaded.end(), share.loaded.begin(), share.loaded.end());
            contacts.insert(contacts.end(), share.inner_contacts.begin(), share.inner_contacts.end());
            elements.insert(elements.end(), share.inner_elements.begin(), share.inner_elements.end());
        }
        const Assemblage& a = grains.run.assemblage;
        EXPECT_EQ(nodes, a.part.nodes.own);
        EXPECT_EQ(loaded, a.part.nodes.own);
        EXPECT_EQ(contacts, a.part.evaluated_contacts.inner);
        std::sort(contacts.begin(), contacts.end());
        EXPECT_EQ(contacts, a.part.contacts.own);
        EXPECT_EQ(elements, a.part.elements.own);
    }
}

// Contacts lie class by class, each class all over the specimen. If two threads divided them so, half of the nodes of a thread's
// contacts would be the other one's. In the order of the nodes, only chunks across the middle have both.
TEST(StepShares, GiveAThreadTheContactsOfItsNodes) {
    const LoadedGrains grains(48);
    const Assemblage& a = grains.run.assemblage;
    const StepShares shares = grains.shares(2);
    const std::int32_t first_of_second = a.node_chunks[shares.of_threads[1].nodes.front()].nodes.begin;
    double foreign = 0, all = 0;
    for (std::size_t thread = 0; thread < 2; ++thread) {
        for (const std::int32_t chunk : shares.of_threads[thread].inner_contacts) {
            const Range contacts = a.contact_chunks[chunk].contacts;
            for (std::int32_t c = contacts.begin; c < contacts.end; ++c) {
                for (const std::int32_t node : a.contacts[c].nodes) {
                    foreign += (node >= first_of_second) != (thread == 1) ? 1 : 0;
                    ++all;
                }
            }
        }
    }
    EXPECT_LT(foreign, 0.1 * all);
}

TEST(StepShares, AreEvenBeforeAndAfterFailure) {
    for (const auto& [columns, limits] : {std::pair{24, std::array{1.1, 1.1, 1.15, 1.35}}, {158, {1.05, 1.05, 1.05, 1.05}}}) {
        LoadedGrains grains(columns);
        for (const bool failed : {false, true}) {
            std::fill_n(grains.run.state.failed.begin(), failed ? grains.run.state.failed.size() / 3 : 0, 1);
            for (std::size_t i = 0; i < limits.size(); ++i) {
                SCOPED_TRACE(::testing::Message() << columns << " columns, " << (2 << i) << " threads, failed " << failed);
                const StepBalance balance = grains.shares(2 << i).balance;
                EXPECT_LE(balance.nodes, limits[i]);
                EXPECT_LE(balance.forces, limits[i]);
                EXPECT_GE(std::min(balance.nodes, balance.forces), 1);
            }
        }
    }
}

TEST(StepShares, AreOfFewerThreadsInSmallSpecimens) {
    SimulationRequest request;
    request.elements_per_thread = 250;
    for (const auto& [asked, elements, expected] :
         {std::array{8, 60, 1}, {8, 499, 1}, {8, 500, 2}, {2, 1122, 2}, {1, 100000, 1}}) {
        request.threads = asked;
        EXPECT_EQ(request.threads_for(static_cast<std::size_t>(elements)), expected);
    }
    request.elements_per_thread = 0;
    EXPECT_EQ(request.threads_for(1), 1);
}

}  // namespace
}  // namespace graincrack::test
