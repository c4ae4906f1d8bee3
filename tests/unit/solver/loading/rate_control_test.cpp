// The automatic rate and loading in blocks: measures in, speed out.
#include "solver/loading/rate_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/check.hpp"

namespace graincrack::test {
namespace {

constexpr double tolerance = 5e-3;
constexpr RateScales scales{0.16, 5e-5, 3e-4, 10};
constexpr double wave_speed = 0.16 / 5e-5;
constexpr double duration = 0.25 * scales.transit_time;

Feedback measures(double kinetic_energy, double stored_energy, double near_failure, double unbalanced_ratio = 0,
                  double force_difference = 0, double damping_load = 0) {
    return {0, 0, 0, unbalanced_ratio, kinetic_energy, stored_energy, force_difference, damping_load, near_failure};
}

/// An elastic bar of unit mass and modulus between the platens, without ringing: K = m v²/6, U = ½ E ε² V with c² = E V/m.
class Bar {
public:
    explicit Bar(double near_failure, double tolerance_of_control = tolerance, double share = 1)
        : control_(tolerance_of_control, scales, share), near_failure_(near_failure) {}
    /// Speed after further intervals.
    double speed_after(int intervals) {
        for (int i = 0; i < intervals; ++i) {
            const double stored = 0.5 * mass * wave_speed * wave_speed * strain_ * strain_;
            speed_ = control_.next(
                measures(mass * speed_ * speed_ / 6, stored, near_failure_, unbalanced_ratio, difference, damping_load), strain_,
                duration);
            strain_ += 2 * speed_ * duration / scales.height;
        }
        return speed_;
    }
    [[nodiscard]] double strain() const { return strain_; }
    double unbalanced_ratio = 0, difference = 0, damping_load = 0;

private:
    // With this mass the bar stores `least_energy` at `least_strain`.
    static constexpr double mass = 2 * scales.min_energy / (wave_speed * wave_speed * scales.min_strain * scales.min_strain);
    RateControl control_;
    double near_failure_;
    double speed_ = 0, strain_ = 0;
};

TEST(RateControl, RaisesTheLoadByTheToleranceInATransitNearDamage) {
    Bar bar(1.0);
    // The speed follows the strain, which grows e-fold in 1/T = 200 transits, with a lag of 4 + 1 transits: 2.5 % below.
    const double speed = bar.speed_after(4 * 400);
    expect_close(2 * speed / (wave_speed * bar.strain()), tolerance, 0.03, tolerance);
}

TEST(RateControl, HalvesItsSpeedAtHalfTheShare) {
    const RateControl whole(tolerance, scales);
    const RateControl half(tolerance, scales, 0.5);
    EXPECT_EQ(half.max_speed(1e-3, 0), whole.max_speed(1e-3, 0) / 2);
    EXPECT_EQ(half.max_speed(1e-3, 1), whole.max_speed(1e-3, 1) / 2);
    for (const double near_failure : {0.0, 1.0}) {
        const double allowed = whole.allowed(near_failure);
        EXPECT_EQ(half.allowed(near_failure), allowed / 2);
        EXPECT_EQ(half.min_speed(1e-3, allowed / 2), whole.min_speed(1e-3, allowed) / 2);
    }
    Bar faster(1.0);
    Bar slower(1.0, tolerance, 0.5);
    const double speed = faster.speed_after(4 * 400) / faster.strain();
    expect_close(slower.speed_after(4 * 800) / slower.strain(), speed / 2, 0.02, speed / 2);  // lags as above
}

TEST(RateControl, IsFasterUpToALimitFarFromDamage) {
    const RateControl control(tolerance, scales);
    Bar far(0);
    Bar near(1.0);
    EXPECT_GT(far.speed_after(400), 3 * near.speed_after(400));
    const double speed = far.speed_after(400);
    EXPECT_LE(speed, control.max_speed(far.strain(), 0));
    // 0.1 is kinetic over stored energy of 1e-3; once contacts are near failure, first peaks ask for less (share/doc/loading.md).
    EXPECT_LE(control.max_speed(1e-3, 0) * 2 * scales.transit_time / scales.height, 0.1 * 1e-3);
    expect_close(control.max_speed(1e-3, 0.1) * 2 * scales.transit_time / scales.height, 0.015e-3, 1e-12, 1e-5);
    EXPECT_EQ(control.max_speed(1e-3, 1), control.max_speed(1e-3, 0.1));
    EXPECT_GT(control.allowed(0), 10 * tolerance);
    EXPECT_LE(control.allowed(0) * control.allowed(0) / 12, 1e-3);  // kinetic over stored energy (quasi-static, as tests ask)
    EXPECT_EQ(control.allowed(1), tolerance);
}

TEST(RateControl, SlowsDownToItsFloorWhereAMeasureExceedsTheTolerance) {
    for (double Bar::*const measure : {&Bar::unbalanced_ratio, &Bar::difference, &Bar::damping_load}) {
        Bar bar(1.0);
        const double before = bar.speed_after(1000);
        bar.*measure = 20 * tolerance;
        double last = before;
        for (int i = 0; i < 40; ++i) {
            const double speed = bar.speed_after(1);
            EXPECT_GE(speed, last * std::exp(-duration / (3.9 * scales.transit_time)));  // e-fold in four transits
            last = speed;
        }
        EXPECT_LT(bar.speed_after(100), 0.1 * before);
        const RateControl control(tolerance, scales);
        expect_close(bar.speed_after(1), control.min_speed(bar.strain(), tolerance), 1e-3, last);
    }
}

TEST(RateControl, TakesAKineticEnergyBelowZeroForNone) {
    RateControl turning(tolerance, scales);
    RateControl resting(tolerance, scales);
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(turning.next(measures(-1e-3, 1, 1), 1e-4, duration), resting.next(measures(0, 1, 1), 1e-4, duration));
    }
}

TEST(RateControl, StaysSlowOnceDamageWasNear) {
    RateControl control(tolerance, scales);
    double speed = 0;
    for (int i = 0; i < 2000; ++i) speed = control.next(measures(0, 100, i == 0 ? 1.0 : 0.0), 1e-3, duration);
    RateControl never_near(tolerance, scales);
    double free_speed = 0;
    for (int i = 0; i < 10; ++i) free_speed = never_near.next(measures(0, 100, 0), 1e-3, duration);
    EXPECT_EQ(speed, control.max_speed(1e-3, 1));  // nothing moves: no measure holds it
    EXPECT_GT(free_speed, 5 * control.min_speed(1e-3, tolerance));
    RateControl started(tolerance, scales);
    EXPECT_EQ(started.next(measures(0, 100, 1), 1e-3, duration), control.min_speed(1e-3, tolerance));
    EXPECT_LT(started.next(measures(0, 100, 0), 1e-3, duration), 1.1 * control.min_speed(1e-3, tolerance));
}

constexpr HeatingScales heating_scales{5e-5, 4, 1000};

/// A specimen that is heated by so many kelvin in all. \return its rates
std::vector<double> rates_of_heating(const Feedback& feedback, double to, int intervals, double share = 1) {
    HeatingControl control(tolerance, heating_scales, share);
    std::vector<double> rates;
    for (double change = 0; static_cast<int>(rates.size()) < intervals; change += rates.back() * duration) {
        rates.push_back(control.next(feedback, change, to - change, duration));
    }
    return rates;
}
Feedback cracking(double unbalanced_ratio = 0, double element_force = 1e6) {
    return {.unbalanced_ratio = unbalanced_ratio, .near_failure = 1, .element_force = element_force};
}

TEST(HeatingControl, RaisesTheStressByTheToleranceInATransitWhereMineralsCrack) {
    constexpr double far = 1e9;  // K, so that the end is not near
    const std::vector<double> rates = rates_of_heating(cracking(), far, 4 * 800);
    double change = 0;
    for (std::size_t i = 0; i + 1 < rates.size(); ++i) change += rates[i] * duration;
    // The rate follows the change, which grows e-fold in 1/T = 200 transits, with a lag of 4: 2 % below.
    expect_close(rates.back() * heating_scales.transit_time / change, tolerance, 0.03, tolerance);
    const std::vector<double> half = rates_of_heating(cracking(), far, 4 * 200, 0.5);
    expect_close(half.back(), rates[4 * 100] / 2, 0.05, half.back());  // the start takes its transits in both
    EXPECT_GT(rates_of_heating(measures(0, 0, 0), far, 4 * 100).back(), 10 * rates[4 * 100]);
    for (std::size_t i = 1; i < rates.size(); ++i) EXPECT_LE(rates[i], rates[i - 1] * std::exp(0.25 / 3.9) * (1 + 1e-9));
}

// Energies go with the square of stress: 10⁴ times the least is the stress of 100 times the least change.
TEST(HeatingControl, CountsTheStressThereIsAlready) {
    Feedback cooling = cracking();
    cooling.stored_energy = 1e4;
    const double rate = rates_of_heating(cooling, 1e9, 4 * 40).back();
    expect_close(rate * heating_scales.transit_time / 400, tolerance, 0.01, tolerance);  // it follows by half a per mille
}

TEST(HeatingControl, SlowsDownByUnbalancedForcesUnlessThereAreNoOthers) {
    const HeatingControl control(tolerance, heating_scales);
    EXPECT_EQ(rates_of_heating(cracking(20 * tolerance), 1e9, 400).back(), control.min_rate(0));
    EXPECT_EQ(rates_of_heating(cracking(1, 0), 1e9, 400), rates_of_heating(cracking(), 1e9, 400));
}

TEST(HeatingControl, ComesToAStop) {
    double change = 0;
    const std::vector<double> rates = rates_of_heating(cracking(), 300, 4 * 1200);
    for (const double rate : rates) change += rate * duration;
    EXPECT_GE(change, 300);
    EXPECT_LT(rates.back(), 1e-3 * *std::max_element(rates.begin(), rates.end()));
    const HeatingControl control(tolerance, heating_scales);
    EXPECT_LT(control.usual_time(300), 1200 * heating_scales.transit_time);
}

}  // namespace
}  // namespace graincrack::test
