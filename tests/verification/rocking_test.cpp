// A block that rocks on its edge, and one on a slope that stands, slides or topples.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/blocks.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using std::numbers::pi;

/// Turn of a grain from two of its nodes, rad, counter-clockwise.
double turn_of(const SmallRun& run, std::int32_t from, std::int32_t to) {
    const Vector2 before = run.assemblage.position[to] - run.assemblage.position[from];
    const Vector2 after = before + run.state.displacement[to] - run.state.displacement[from];
    return std::atan2(before.x * after.y - before.y * after.x, dot(before, after));
}
/// Node of a grain that is the farthest along a direction.
std::int32_t node_towards(const SmallRun& run, std::int32_t grain, const Vector2& direction) {
    std::int32_t best = -1;
    for (std::int32_t i = 0; i < run.assemblage.n_nodes(); ++i) {
        if (run.assemblage.surface.grain_of_node[i] != grain) continue;
        if (best < 0 || dot(run.assemblage.position[i], direction) > dot(run.assemblage.position[best], direction)) best = i;
    }
    return best;
}

// --- rocking -----------------------------------------------------------------------------------------------------------

/// Housner (1963, Bull. Seism. Soc. Am. 53, 403–417): a block of half width b and half height h that is let go at θ0 turns about
/// its edge by I θ'' = −m g R sin(α − θ), R² = b² + h², tan α = b/h, I = 4/3 m R². For slender blocks a quarter of its period is
/// acosh(1/(1 − θ0/α))/p, p² = 3 g/(4 R).
struct RockingBlock {
    double half_width = 0.25, half_height = 1;
    [[nodiscard]] double radius() const { return std::hypot(half_width, half_height); }
    [[nodiscard]] double alpha() const { return std::atan2(half_width, half_height); }
    [[nodiscard]] double rate() const { return std::sqrt(3 * earth / (4 * radius())); }
    [[nodiscard]] double slender_quarter(double turn) const { return std::acosh(1 / (1 - turn / alpha())) / rate(); }
    /// The turn to the other side: an impact without rebound about the other edge leaves (1 − 3/2 sin² α)² of the energy.
    [[nodiscard]] double turn_after_impact(double turn) const {
        const double left = std::pow(1 - 1.5 * std::pow(std::sin(alpha()), 2), 2);
        return alpha() * (1 - std::sqrt(1 - left * (1 - std::pow(1 - turn / alpha(), 2))));
    }
    /// Without the assumption of slenderness: ∫ dθ/θ' with θ'² = 2 p² (cos(α − θ) − cos(α − θ0)); θ = θ0 (1 − x²) takes away the
    /// root at the start. By the midpoint rule.
    [[nodiscard]] double quarter(double turn) const {
        constexpr int n = 20000;
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            const double x = (i + 0.5) / n;
            const double theta = turn * (1 - x * x);
            const double fall = 2 * std::sin(alpha() - 0.5 * (turn + theta)) * std::sin(0.5 * (turn - theta));
            sum += 2 * turn * x / std::sqrt(2 * fall) / n;
        }
        return sum / rate();
    }
};

void rock_from(double share) {
    const RockingBlock block;
    const double turn = share * block.alpha();
    ProgramRun swing(separate_blocks({{3, 1, -0.9, -0.3, 1.6, 0.3}, {4, 16, -0.25, 1e-6, 0.5, 2, -turn}}), R"(
        name = "rock"
        gravity = [0, "-9.81 m/s2"]
        stages = ["rock"]
        boundary.base = { box = ["-2 m", "2 m", "-1 m", 0], velocity_x = 0.0, velocity_y = 0.0 }
        stage.rock.until.time = "1 s"
    )",
                     joint_law(1e12, 1e12, std::tan(70 * degree)), PlaneCondition::strain, 0, 0.7);
    SmallRun& run = swing.run;
    run.begin();
    const std::int32_t left = node_towards(run, 1, {-1, -0.01});
    const std::int32_t right = node_towards(run, 1, {0, -1});
    std::vector<double> time{0};
    std::vector<double> lean{turn};
    double slid = 0;  // while it falls
    while (time.back() < 2.5 * block.quarter(turn)) {
        swing.go_on(100);
        time.push_back(run.state.time);
        lean.push_back(turn - turn_of(run, left, right));
        if (lean.back() > 0) slid = std::max(slid, std::abs(run.state.displacement[right].x));
    }
    record_curves(fmt::format("rocking-{}", share), {{"time_s", time}, {"turn_rad", lean}});
    std::size_t i = 1;
    while (lean[i] > 0) ++i;
    const double upright = time[i - 1] + (time[i] - time[i - 1]) * lean[i - 1] / (lean[i - 1] - lean[i]);
    const std::string name = fmt::format("dynamics: rocking block, let go at {} of its slenderness, ", share);
    verify(name + "quarter of the period (s)", upright, block.quarter(turn), 0.003, "Housner (1963), by quadrature");
    verify(name + "the same, slender (s)", upright, block.slender_quarter(turn), 0.005, "Housner (1963), acosh(1/(1 - x))/p");
    // Energy of rocking is lost by impact: all that Housner's impact without rebound takes, or less where springs give it back.
    const double least = block.turn_after_impact(turn) / turn;
    verify_between(name + "next turn over the first", -*std::min_element(lean.begin(), lean.end()) / turn, least, 1,
                   "between Housner's impact and none");
    EXPECT_LT(slid, 1e-4) << "it should not slide";
}
// Let go at half and at four fifths of its slenderness a block is upright after a quarter of the period by quadrature, to 0.3 %,
// and of Housner's closed form, to 0.5 %: lumped masses make it fall 0.09 % too late.
TEST(RockingBlock, FallsAsHousnerHasIt) {
    rock_from(0.5);
    rock_from(0.8);
}

// --- standing, sliding, toppling -----------------------------------------------------------------------------------------

/// A block that has settled on a level base, and whose base is tilted: gravity turns.
class TiltTable {
public:
    /// \param slenderness b/h
    TiltTable(double slenderness, double friction)
        : fall_(separate_blocks(
                    {{5, 1, -0.15, -0.05, 0.35, 0.05},
                     {std::max(2, static_cast<int>(std::lround(6 * slenderness))), 6, 0, 1e-9, slenderness * height, height}}),
                fmt::format(R"(
        name = "settle"
        gravity = [0, {}]
        stages = ["settle"]
        boundary.base = {{ box = ["-2 m", "2 m", "-1 m", "-10 mm"], velocity_x = 0.0, velocity_y = 0.0 }}
        stage.settle.until = {{ time = "50 ms", rest = 1e-5 }}
    )",
                            -gravity),
                joint_law(1e12, 1e12, std::tan(friction)), PlaneCondition::strain, 0.8, 0.7) {
        fall_.go(100);
        left_ = node_towards(run(), 1, {-1, -0.01});
        right_ = node_towards(run(), 1, {1, -0.01});
    }
    [[nodiscard]] SmallRun& run() { return fall_.run; }
    void hold(double slope, double duration) {
        run().boundary.prescribed.gravity = {-gravity * std::sin(slope), -gravity * std::cos(slope)};
        const double end = run().state.time + duration;
        while (run().state.time < end) fall_.go_on(20);
    }
    [[nodiscard]] double turn() { return turn_of(run(), left_, right_); }
    [[nodiscard]] double slid() { return -run().state.displacement[left_].x; }

    static constexpr double height = 0.1;
    static constexpr double gravity = 100 * earth;  // thresholds are free of it

private:
    ProgramRun fall_;
    std::int32_t left_ = 0, right_ = 0;
};

/// Tilts up to where the block moves: a block with its centre above its edge topples, b/h = tan α; one slides at the slope of its
/// friction; whichever comes first (Goodman & Bray 1976).
void expect_threshold(double slenderness, double friction) {
    constexpr double step = 0.005;
    TiltTable table(slenderness, friction * degree);
    const double tan_friction = std::tan(friction * degree);
    const double expected = std::min(tan_friction, slenderness);
    table.run().parameters.damping = 0.5;
    for (int i = 1; i <= 10; ++i) table.hold(std::atan(0.096 * i * expected), 2e-3);
    std::vector<double> slope;
    std::vector<double> turn;
    std::vector<double> slid;
    for (int i = 1; i <= 30 && std::abs(table.turn()) < 0.005 && table.slid() < 1e-4; ++i) {
        slope.push_back(0.96 + step * i);
        table.hold(std::atan(slope.back() * expected), 0.03);
        turn.push_back(table.turn());
        slid.push_back(table.slid());
    }
    record_curves(fmt::format("tilt-{:.1f}-{:.0f}", slenderness, friction),
                  {{"slope_over_threshold", slope}, {"turn_rad", turn}, {"slid_m", slid}});
    const bool topples = slenderness < tan_friction;
    verify(fmt::format("dynamics: tilted block, b/h {}, friction {} deg, tan of the slope at which it {}", slenderness, friction,
                       topples ? "topples" : "slides"),
           slope.back() * expected, expected, 0.0075, "Goodman & Bray (1976), steps of 0.5 %");
    EXPECT_EQ(std::abs(turn.back()) > 1e-3, topples);
    EXPECT_EQ(slid.back() > 1e-4, !topples);
}
// tan α = b/h or tan φ (Goodman & Bray 1976), to steps of the slope of 0.5 %.
TEST(TiltedBlock, TopplesOrSlidesAtTheLowerOfBothSlopes) {
    for (const auto& [slenderness, friction] : {std::pair{0.2, 30.0}, {0.4, 30.0}, {0.4, 20.0}, {0.8, 20.0}}) {
        expect_threshold(slenderness, friction);
    }
}

// Where the slope is steeper than friction, a block that slides is turned by its friction alone: it topples for b/h < tan φ, not
// for b/h < tan α (Sagaseta 1986, Rock Mech. Rock Eng. 19, 261–266).
// One that slides has the acceleration g (sin α − cos α tan φ), to 1 %.
TEST(TiltedBlock, TopplesWhileItSlidesBelowTheTangentOfItsFriction) {
    constexpr double slope = 30 * degree;
    constexpr double friction = 20 * degree;
    for (const double slenderness : {0.30, 0.34, 0.38, 0.45}) {
        TiltTable table(slenderness, friction);
        table.run().parameters.damping = 0;
        for (int i = 1; i <= 30; ++i) table.hold(i * slope / 30, 1e-3);
        const auto speed = [&table] { return -mean_of_grain(table.run(), table.run().state.velocity, 1).x; };
        const double time = table.run().state.time;
        const double before = speed();
        table.hold(slope, 10e-3);
        const double acceleration = (speed() - before) / (table.run().state.time - time);
        if (slenderness < std::tan(friction)) {
            EXPECT_GT(table.turn(), 0.3) << slenderness;
        } else {
            EXPECT_LT(std::abs(table.turn()), 0.002) << slenderness;
            verify(fmt::format("dynamics: block that slides, b/h {} between tan phi and tan a, acceleration over g", slenderness),
                   acceleration / TiltTable::gravity, std::sin(slope) - std::cos(slope) * std::tan(friction), 0.01,
                   "sin a - cos a tan phi");
        }
    }
}

}  // namespace
}  // namespace graincrack::test
