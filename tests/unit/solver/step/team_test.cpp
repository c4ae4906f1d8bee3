// The barrier of a team, also with more threads than processors.
#include "solver/step/thread_team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <thread>
#include <vector>

namespace graincrack::test {
namespace {

/// Each thread writes, waits, and must find what all the others wrote; \return what was amiss.
int violations(int n_threads, int rounds) {
    SpinBarrier barrier(n_threads);
    std::vector<int> round_of(static_cast<std::size_t>(n_threads), -1);
    std::atomic<int> wrong{0};
    const auto work = [&](int thread) {
        for (int round = 0; round < rounds; ++round) {
            round_of[thread] = round;
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

TEST(SpinBarrier, LetsNobodyPassBeforeAllHaveCome) {
    EXPECT_EQ(violations(1, 100), 0);
    EXPECT_EQ(violations(2, 5000), 0);
    EXPECT_EQ(violations(3, 2000), 0);
    EXPECT_EQ(violations(16, 200), 0);  // more than most processors: they must let each other run
}

TEST(ThreadTeam, WorksOnEveryPieceOnceByEveryThread) {
    for (const int n : {1, 2, 5}) {
        ThreadTeam team(n);
        ASSERT_EQ(team.size(), n);
        std::vector<int> done(static_cast<std::size_t>(n), 0);
        for (int piece = 1; piece <= 200; ++piece) {
            team.run([&](int thread) {
                ++done[thread];
                team.wait();
                for (const int each : done) EXPECT_EQ(each, piece);
                team.wait();
            });
        }
        EXPECT_EQ(done, std::vector<int>(static_cast<std::size_t>(n), 200));
    }
}

TEST(ThreadTeam, WorksWithAnyNumberOfItsThreads) {
    ThreadTeam team(5);
    for (const int n : {5, 1, 3, 2, 5, 4, 1, 5}) {
        team.resize(n);
        ASSERT_EQ(team.size(), n);
        for (int piece = 0; piece < 50; ++piece) {
            std::vector<int> done(5, 0);
            team.run([&](int thread) {
                ++done[thread];
                team.wait();
                EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), n);
                team.wait();
            });
            EXPECT_EQ(std::count(done.begin(), done.begin() + n, 1), n);
        }
    }
    EXPECT_EQ(team.most(), 5);
}

// The rule of the numbers at work: shares of time as a program would measure them, one second apart.
TEST(TeamSize, ShrinksByTheShareThatWaitedAndGrowsAfterAPause) {
    TeamSize of_sixteen(16);
    EXPECT_EQ(of_sixteen.next(1, 0), 16);
    EXPECT_EQ(of_sixteen.next(1, 0.05), 16) << "a little is nothing";
    EXPECT_EQ(of_sixteen.next(1, 0.25), 12);
    EXPECT_EQ(of_sixteen.next(1, 0), 12);
    EXPECT_EQ(of_sixteen.next(1.5, 0), 15);
    EXPECT_EQ(of_sixteen.next(1, 0.9), 1);
    TeamSize of_two(2);
    int trials = 0;
    for (int second = 0; second < 200; ++second) trials += of_two.next(1, second % 2 == 0 ? 0.3 : 0.0) == 2 ? 1 : 0;
    EXPECT_EQ(trials, 0) << "always disturbed";
    for (int second = 0; second < 200; ++second) trials += of_two.next(1, 0) == 2 ? 1 : 0;
    EXPECT_GT(trials, 160) << "alone again";
    trials = 0;
    int size = 2;
    for (int second = 0; second < 330; ++second) {
        size = of_two.next(1, size == 2 ? 0.4 : 0);
        trials += size == 2 ? 1 : 0;
    }
    EXPECT_LE(trials, 15) << "with one processor a trial fails, and the pause between trials doubles up to 32 s";
}

}  // namespace
}  // namespace graincrack::test
