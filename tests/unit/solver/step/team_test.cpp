// The barrier of a team, also with more threads than processors.
#include "solver/step/thread_team.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace graincrack {
namespace {

/// Each thread writes, waits, and must find what all the others wrote; \return what was amiss.
int violations(int n_threads, int rounds) {
    SpinBarrier barrier(n_threads);
    std::vector<int> round_of(static_cast<std::size_t>(n_threads), -1);
    std::atomic<int> wrong{0};
    const auto work = [&](int thread) {
        for (int round = 0; round < rounds; ++round) {
            round_of[static_cast<std::size_t>(thread)] = round;
            barrier.wait();
            for (const int other : round_of) wrong += other == round ? 0 : 1;
            barrier.wait();
        }
    };
    std::vector<std::thread> team;
    for (int thread = 0; thread < n_threads; ++thread) team.emplace_back(work, thread);
    for (std::thread& thread : team) thread.join();
    return wrong;
}

TEST(SpinBarrier, NobodyPassesBeforeAllHaveCome) {
    EXPECT_EQ(violations(1, 100), 0);
    EXPECT_EQ(violations(2, 5000), 0);
    EXPECT_EQ(violations(3, 2000), 0);
    EXPECT_EQ(violations(16, 200), 0);  // more than most processors: they must let each other run
}

TEST(ThreadTeam, EveryThreadWorksOnEveryPieceOnce) {
    for (const int n : {1, 2, 5}) {
        ThreadTeam team(n);
        ASSERT_EQ(team.size(), n);
        std::vector<int> done(static_cast<std::size_t>(n), 0);
        for (int piece = 1; piece <= 200; ++piece) {
            team.run([&](int thread) {
                ++done[static_cast<std::size_t>(thread)];
                team.wait();
                for (const int each : done) EXPECT_EQ(each, piece);
                team.wait();
            });
        }
        EXPECT_EQ(done, std::vector<int>(static_cast<std::size_t>(n), 200));
    }
}

}  // namespace
}  // namespace graincrack
