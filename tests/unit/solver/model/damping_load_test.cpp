// The load that damping carries: motions and forces set by hand.
#include "solver/model/damping_load.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

constexpr double transit = 1e-4;
constexpr double time_constant = mean_transits * transit;

/// A specimen whose nodes all move at v(t) along y and are held back by D(t) each, under platens of unit power; the share after
/// fifty time constants.
template <class Velocity, class DampingForce>
double share_of(Velocity&& velocity, DampingForce&& damping_force) {
    SmallRun run(one_diagonal_grid(2, 2, 0.02, 0.02), augig_law());
    State& s = run.state;
    const double interval = 0.05 * transit;
    for (int i = 1; i <= 4000; ++i) {
        const double t = i * interval;
        for (Vector2& u : s.displacement) u.y += interval * velocity(t);
        std::fill(s.damping_force.begin(), s.damping_force.end(), Vector2{0, -damping_force(t)});
        s.time = t;
        follow_damping_load(run.assemblage, s, 1, time_constant, s.damping_load);
    }
    return s.damping_load.fraction() / static_cast<double>(s.damping_force.size());
}

TEST(DampingLoad, IsThePowerOfDampingOnSteadyMotionOverThatOfThePlatens) {
    // The mean of intervals of 1/80 time constant lags by half of one.
    expect_close(share_of([](double) { return 0.3; }, [](double) { return 2.0; }), 0.6, 0.01, 0.6);
    EXPECT_EQ(share_of([](double) { return 0.0; }, [](double) { return 2.0; }), 0);
}

TEST(DampingLoad, LeavesOutWhatDampingTakesFromWaves) {
    // An oscillation of half a transit that damping opposes in every instant: no power on the mean motion.
    const auto v = [](double t) { return std::sin(2 * M_PI * t / (0.5 * transit)); };
    const double share = share_of(v, [&](double t) { return std::copysign(1.0, v(t)); });
    expect_close(share, 0, 0.02, 2 / M_PI);  // 2/π is all that it takes
    // The same on top of steady motion, with a damping force that acts as often along it as against it.
    EXPECT_LT(std::abs(share_of([&](double t) { return 0.1 + v(t); }, [&](double t) { return std::copysign(1.0, v(t)); })), 0.02);
}

TEST(DampingLoad, StaysWhenTheSameInstantIsFollowedAgain) {
    SmallRun run(one_diagonal_grid(2, 2, 0.02, 0.02), augig_law());
    State& s = run.state;
    s.displacement.assign(s.displacement.size(), {1e-6, 0});
    s.damping_force.assign(s.damping_force.size(), {-1, 0});
    s.time = transit;
    follow_damping_load(run.assemblage, s, 1, time_constant, s.damping_load);
    const double once = s.damping_load.fraction();
    EXPECT_GT(once, 0);
    follow_damping_load(run.assemblage, s, 1, time_constant, s.damping_load);
    EXPECT_EQ(s.damping_load.fraction(), once);
    s.damping_load.platen_power = 1e-310;  // as of platens that have left it
    EXPECT_EQ(s.damping_load.fraction(), 0);
}

}  // namespace
}  // namespace graincrack::test
