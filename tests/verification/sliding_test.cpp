// Friction, rate and cycles where the answer is known in closed form: a joint that slips under a shear wave, a slipping crack
// under a cycle of load, a block on a base that is accelerated.
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

// --- slip under a harmonic shear wave --------------------------------------------------------------------------------

/// Energies of the waves over that of the incident one.
struct Shares {
    double transmitted, reflected, absorbed;
};
/// Miller (1978, Int. J. Num. Anal. Meth. Geomech. 2, 391–407) for a rigid joint of the shear strength τs = `ratio` τ0. The joint
/// bears what the incident wave brings, τ0 sin ωt, but not more than τs; that is the transmitted wave, and the rest is reflected.
Shares shares_of_rigid_joint(double ratio) {
    const double a = std::asin(ratio);
    const double transmitted = 4 / pi * (a / 2 - std::sin(2 * a) / 4 + ratio * ratio * (pi / 2 - a));
    const double reflected =
        4 / pi * ((pi / 2 - a) / 2 + std::sin(2 * a) / 4 - 2 * ratio * std::cos(a) + ratio * ratio * (pi / 2 - a));
    return {transmitted, reflected, 1 - transmitted - reflected};
}

/// A column of 2.5 wavelengths with a joint in its middle. The second period of the wave passes the joint before reflections from
/// the ends do.
struct WaveColumn {
    static constexpr double frequency = 10e3;
    static constexpr double amplitude = 0.1e6;
    static constexpr double stress = 10e6;  ///< normal to the joint, Pa
    static constexpr double length = 0.5;
    double arrival = 0;  ///< of the wave at the joint, s
    ContactLaw law;
};
ProgramRun run_of_column(const WaveColumn& c) {
    constexpr int cells = 200;
    const double length = WaveColumn::length;
    Specimen specimen = crossed_blocks(1, cells, length / cells, length, [](int, int j) { return j < cells / 2 ? 0 : 1; });
    break_contacts(specimen, [](double, double) { return true; });
    ProgramRun column(std::move(specimen),
                      fmt::format(R"(
        name = "wave"
        stages = ["wave"]
        boundary.all = {{ box = ["-1 m", "1 m", "-1 m", "1 m"], velocity_y = 0.0 }}
        boundary.source = {{ on = "bottom", traction_x = {{ sine = {}, frequency = {} }} }}
        probe.below.point = [0, -1e-9]
        probe.above.point = [0, 1e-9]
        stage.wave.until.time = {}
    )",
                                  WaveColumn::amplitude, WaveColumn::frequency, c.arrival + 2 / WaveColumn::frequency),
                      c.law);
    for (std::size_t i = 0; i < column.run.state.displacement.size(); ++i) {  // closed by the normal stress
        const auto& grain = column.run.assemblage.surface.grain_of_node;
        if (grain[i] == 1) column.run.state.displacement[i].y = -WaveColumn::stress / c.law.kt;
    }
    column.go(2);
    return column;
}

void expect_miller(double ratio) {
    constexpr double frequency = WaveColumn::frequency;
    constexpr double amplitude = WaveColumn::amplitude;
    const Rock granite = augig_granite().rock;
    const double impedance = std::sqrt(granite.density * granite.young_modulus / (2 * (1 + granite.poisson_ratio)));
    const double arrival = WaveColumn::length / 2 * granite.density / impedance;
    const ContactLaw law = joint_law(7e13, 7e13, ratio * amplitude / WaveColumn::stress);
    const ProgramRun column = run_of_column({arrival, law});
    const std::vector<double>& time = column[HistoryColumn::time];
    const std::vector<double>& below = column.column("below", "velocity_x");
    const std::vector<double>& above = column.column("above", "velocity_x");
    std::vector<double> slip = column.column("below", "displacement_x");
    for (std::size_t i = 0; i < slip.size(); ++i) {  // less what is elastic
        slip[i] -= column.column("above", "displacement_x")[i] + impedance * above[i] / law.ks;
    }
    double incident = 0, transmitted = 0, reflected = 0;
    std::vector<double> exact(time.size());
    std::vector<double> exact_slip(time.size());
    double least = 0, largest = 0, worst = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double t = time[i] - arrival;
        const double wave = t > 0 ? amplitude * std::sin(2 * pi * frequency * t) : 0;
        exact[i] = std::clamp(wave, -ratio * amplitude, ratio * amplitude);
        exact_slip[i] = exact_slip[i - 1] + 2 * (wave - exact[i]) / impedance * (time[i] - time[i - 1]);
        if (t < 1 / frequency) continue;
        incident += wave * wave;
        transmitted += std::pow(impedance * above[i], 2);
        reflected += std::pow(wave - impedance * below[i], 2);
        least = std::min(least, slip[i]);
        largest = std::max(largest, slip[i]);
        worst = std::max(worst, std::abs(impedance * above[i] - exact[i]));
    }
    const Shares expected = shares_of_rigid_joint(ratio);
    const std::string name = fmt::format("specimens: shear wave on a joint, strength over amplitude {}, ", ratio);
    const std::string source = "Miller (1978)";
    verify(name + "transmitted energy", transmitted / incident, expected.transmitted, 0.003, source, 1);
    verify(name + "reflected energy", reflected / incident, expected.reflected, 0.003, source, 1);
    verify(name + "absorbed energy", 1 - (transmitted + reflected) / incident, expected.absorbed, 0.003, source, 1);
    // Slip of a half wave: ∫ 2 (τ − τs)/Z dt while τ > τs.
    const double half =
        2 * amplitude / impedance / (pi * frequency) * (std::sqrt(1 - ratio * ratio) - ratio * (pi / 2 - std::asin(ratio)));
    verify(name + "slip of a half wave (um)", (largest - least) * 1e6, half * 1e6, 0.01, "2 int (tau - tau_s) dt/Z");
    EXPECT_LT(worst, 0.05 * amplitude);
    record_curves(fmt::format("shear-wave-{}", ratio), {{"time_s", time},
                                                        {"velocity_below_m_s", below},
                                                        {"velocity_above_m_s", above},
                                                        {"slip_m", slip},
                                                        {"exact_stress_above_Pa", exact},
                                                        {"exact_slip_m", exact_slip}});
}
// Energies that a rigid joint transmits, reflects and absorbs (Miller 1978), to 0.3 % of the incident, and the slip of a half
// wave to 1 %, with 80 cells a wave: errors are a quarter of those of 40.
TEST(ShearWave, SlipsOnAJoint) {
    for (const double ratio : {0.1, 0.25, 0.5, 0.75, 0.9}) expect_miller(ratio);
}

// --- a slipping crack under a cycle of load -----------------------------------------------------------------------------

/// A block of width 1 and height 2 with an elastic joint from side to side, the middle part of which has friction only. Between
/// rigid halves, the force P along the block, the approach u and the slip are of a spring and a slider. With k the stiffness of
/// the joint per area (both directions), L its length, a = ℓ/L, c and s the cosine and sine of its slope, μ = tan φ:
///
///   sticking                      1/K = H/(E W) + 1/(k L)
///   sliding under rising load     1/K = H/(E W) + c²/(k L) + s (s − a μ c)/(k L (1 − a))
///   sliding back                  the same with + μ, once P has fallen to P_r = P_m (s − μ c)/(s + μ c)
struct SlippingCrack {
    double young_modulus = 88.9e9, stiffness = 0, slope = pi / 4, share = 10.0 / 26, friction = std::tan(16 * degree);
    double width = 1, height = 2;

    [[nodiscard]] double length() const { return width / std::cos(slope); }
    [[nodiscard]] double sticking() const { return 1 / (height / (young_modulus * width) + 1 / (stiffness * length())); }
    /// \param tan_friction positive where the slip is driven by the load, negative where it goes back
    [[nodiscard]] double sliding(double tan_friction) const {
        const double c = std::cos(slope);
        const double s = std::sin(slope);
        const double joint = c * c + s * (s - share * tan_friction * c) / (1 - share);
        return 1 / (height / (young_modulus * width) + joint / (stiffness * length()));
    }
    [[nodiscard]] double reversal() const { return (std::tan(slope) - friction) / (std::tan(slope) + friction); }
};

/// Least-squares line through the rows of a branch in which the force is between two values.
double slope_between(const std::vector<double>& x, const std::vector<double>& y, std::size_t begin, std::size_t end, double low,
                     double high) {
    double n = 0, sx = 0, sy = 0;
    double sxx = 0, sxy = 0;
    for (std::size_t i = begin; i < end; ++i) {
        if (y[i] < low || y[i] > high) continue;
        n += 1;
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// What a cycle of load gave: stiffnesses (N/m) of loading, unloading at first and then, the force at which the slip turns over
/// the largest, energy that friction took (J).
struct Cycle {
    double loading = 0, unloading = 0, back = 0, reversal = 0, friction = 0, largest = 0;
};
Cycle load_cycle(const SlippingCrack& crack, double time, const std::string& name) {
    Specimen specimen = jointed_rectangle(26, 13, crack.width, crack.height, crack.slope, Blocks::of_one_grain);
    for (std::size_t i = 0; i < specimen.n_contacts(); ++i) {
        const double x = 0.5 * (specimen.node_position[specimen.contact_nodes[i][0]][0] +
                                specimen.node_position[specimen.contact_nodes[i][1]][0]);
        if (std::abs(x) > 0.5 * crack.share * crack.width) {
            specimen.contact_kind[i] = static_cast<std::uint8_t>(ContactKind::grain_boundary);
        }
    }
    Rock solid = augig_granite().rock;
    solid.young_modulus = crack.young_modulus;
    solid.poisson_ratio = 0.26;
    ProgramRun block(std::move(specimen),
                     fmt::format(R"(
        name = "cycle"
        stages = ["cycle"]
        boundary.base = {{ on = "bottom", velocity_y = 0.0 }}
        [boundary.top]
        on = "top"
        velocity_y = {{ times = [0, {0}, {1}, {2}, {3}], values = [0, -0.01, -0.01, 0.01, 0.01] }}
        [stage.cycle]
        until = {{ time = {3} }}
    )",
                                 0.1 * time, 0.95 * time, 1.15 * time, 2.05 * time),
                     joint_law(crack.stiffness, crack.stiffness, crack.friction), PlaneCondition::stress, 0.8, 0.7, solid);
    block.go(20);
    std::vector<double> force = block.column("top", "force_y");
    std::vector<double> approach = block.column("top", "displacement_y");
    for (double& value : force) value *= -1;
    for (double& value : approach) value *= -1;
    record_curves(name, {{"approach_m", approach}, {"force_N", force}});
    const auto peak = static_cast<std::size_t>(std::max_element(approach.begin(), approach.end()) - approach.begin());
    const double largest = force[peak];
    const double turn = crack.reversal() * largest;
    Cycle cycle;
    cycle.largest = approach[peak];
    cycle.loading = slope_between(approach, force, 0, peak, 0.2 * largest, 0.9 * largest);
    cycle.unloading = slope_between(approach, force, peak, force.size(), 1.1 * turn, 0.97 * largest);
    cycle.back = slope_between(approach, force, peak, force.size(), 0.2 * turn, 0.9 * turn);
    // The lines of both branches of unloading meet where the slip turns; that of sliding back goes through the origin.
    const double meet = (largest - cycle.unloading * approach[peak]) / (cycle.back - cycle.unloading);
    cycle.reversal = cycle.back * meet / largest;
    cycle.friction = block.energies.back().friction;
    return cycle;
}

// Halves that are 130 times as stiff as the joint: rigid to a thousandth or two. Stiffnesses of the branches to
// 0.5 %, the turn of the slip and the energy of friction, the triangle between the three lines, to 1 %.
TEST(SlippingCrack, HasTheLoopOfRigidHalves) {
    SlippingCrack crack;
    crack.stiffness = 0.55e9;
    const Cycle cycle = load_cycle(crack, 0.2, "slipping-crack-soft");
    const std::string name = "specimens: slipping crack under a cycle of load, soft joint, ";
    const std::string source = "spring and slider, halves 1/130 as soft";
    verify(name + "loading (GN/m)", cycle.loading * 1e-9, crack.sliding(crack.friction) * 1e-9, 0.005, source);
    verify(name + "unloading at first (GN/m)", cycle.unloading * 1e-9, crack.sticking() * 1e-9, 0.005, source);
    verify(name + "unloading, slip back (GN/m)", cycle.back * 1e-9, crack.sliding(-crack.friction) * 1e-9, 0.005, source);
    verify(name + "force at which slip turns over the largest", cycle.reversal, crack.reversal(), 0.01, source);
    // Friction takes the triangle between the three lines.
    const double force = crack.sliding(crack.friction) * cycle.largest;
    const double turn = crack.reversal() * force;
    const double turned = turn / crack.sliding(-crack.friction);
    verify(name + "energy of friction (J)", cycle.friction, 0.5 * (force * turned - turn * cycle.largest), 0.01, source);
}

// The values of the problem as UDEC and 3DEC have it (Brady et al. 1985, after Olsson 1982). Its closed form for sliding, 1/K =
// 1/K_stick + s (s ∓ μ c)/(k (L − ℓ)), is no equilibrium of rigid halves, which have ℓ/L times the second term, but stands for
// the strain of the halves beside the crack: to 2 %.
TEST(SlippingCrack, IsThatOfBrady) {
    SlippingCrack crack;
    crack.stiffness = 220e9;
    const Cycle cycle = load_cycle(crack, 0.02, "slipping-crack");
    const std::string name = "specimens: slipping crack under a cycle of load, ";
    const std::string source = "Brady et al. (1985), a model to some per cent";
    verify(name + "loading (GN/m)", cycle.loading * 1e-9, 36.28, 0.02, source);
    verify(name + "unloading at first (GN/m)", cycle.unloading * 1e-9, 38.89, 0.02, source);
    verify(name + "unloading, slip back (GN/m)", cycle.back * 1e-9, 34.42, 0.02, source);
}

// --- a block on a base that is accelerated ------------------------------------------------------------------------------

/// A block on a base with a slope, under a pulse of acceleration up the slope. Newmark (1965, Géotechnique 15, 139–160): after
/// the pulse, a over t, the base has the speed v = a t. The block follows with the acceleration A = g (cos β tan φ − sin β) that
/// friction gives it, and has slid v²/(2 A) (1 − A/a) when it is as fast.
struct NewmarkBlock {
    double slope = 0, friction = 20 * degree;  // rad
    double acceleration = earth, duration = 0.1;
    [[nodiscard]] double yield() const { return earth * (std::cos(slope) * std::tan(friction) - std::sin(slope)); }
    [[nodiscard]] double slip() const {
        return std::pow(acceleration * duration, 2) / (2 * yield()) * (1 - yield() / acceleration);
    }
    [[nodiscard]] double end() const { return acceleration * duration / yield(); }
};

void expect_newmark(const NewmarkBlock& problem) {
    // Soft springs, so that the block slides as a rigid one: on stiff ones an elastic block chatters. The block settles, damped.
    const ContactLaw soft = joint_law(1e10, 1e10, std::tan(problem.friction));
    ProgramRun block(separate_blocks({{10, 1, -0.7, -0.1, 1.0, 0.1}, {8, 2, -0.237, 0, 0.4, 0.1}}),
                     fmt::format(R"(
        name = "settle"
        gravity = [{}, {}]
        stages = ["settle"]
        boundary.base = {{ box = ["-1 m", "1 m", "-1 m", "-10 mm"], velocity_x = 0.0, velocity_y = 0.0 }}
        stage.settle.until = {{ time = "100 ms", rest = 1e-6 }}
    )",
                                 -earth * std::sin(problem.slope), -earth * std::cos(problem.slope)),
                     soft, PlaneCondition::strain, 0.8, 0.7);
    block.go(100);
    SmallRun& run = block.run;
    EXPECT_EQ(block.stage_controller.records().at(0).ended_by, "rest");
    run.parameters.damping = 0;
    const TimeFunction speed{.kind = TimeFunction::Kind::table,
                             .times = {0, problem.duration},
                             .values = {0, problem.acceleration * problem.duration}};
    const double begin = run.state.time;
    const std::vector<Amplitude> amplitudes{{speed, begin, true}, {{}, 0, true}};
    const auto lag = [&run](const std::vector<Vector2>& field) {
        return mean_of_grain(run, field, 0).x - mean_of_grain(run, field, 1).x;
    };
    const double start = lag(run.state.displacement);
    std::vector<double> time;
    std::vector<double> velocity;
    std::vector<double> slip;
    while (run.state.time - begin < 1.3 * problem.end()) {
        run.steps(50, {{}, {}, &amplitudes});
        time.push_back(run.state.time - begin);
        velocity.push_back(mean_of_grain(run, run.state.velocity, 1).x);
        slip.push_back(lag(run.state.displacement) - start);
    }
    const std::string text = fmt::format("dynamics: Newmark's block, slope {:.0f} deg, ", problem.slope / degree);
    verify(text + "slip (mm)", slip.back() * 1e3, problem.slip() * 1e3, 0.005, "Newmark (1965)");
    const std::size_t half = slip.size() / 2;
    verify(text + "acceleration of the block (m/s2)", velocity[half] / time[half], problem.yield(), 0.01,
           "g (cos b tan phi - sin b)");
    EXPECT_NEAR(slip.back(), slip[slip.size() * 9 / 10], 1e-3 * problem.slip()) << "it should stick in the end";
}
// The slip on a level base and on a slope of 10°, to 0.5 %: friction is there after a quarter of the period of the block on its
// springs, 0.25 ms of 200.
TEST(NewmarkBlock, SlidesAsNewmarkHasIt) {
    expect_newmark({});
    expect_newmark({.slope = 10 * degree, .duration = 0.08});
}

}  // namespace
}  // namespace graincrack::test
