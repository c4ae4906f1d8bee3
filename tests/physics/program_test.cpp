// What programs make possible, where the answer is known: free fall, weight, uniform tractions, a block on a slope, a joint in
// shear, waves and their reflections; and the energy balance of every force a program exerts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/blocks.hpp"
#include "tests/support/check.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using std::numbers::pi;

constexpr double gravity_on_earth = 9.81;
const Rock rock_of_programs = augig_granite().rock;

/// Two blocks on each other, cut by a crack.
Specimen two_blocks(int nx, int ny, double width, double height) {
    Specimen s = crossed_blocks(nx, 2 * ny, width, height, [ny](int, int j) { return j < ny ? 0 : 1; });
    break_contacts(s, [](double, double) { return true; });
    return s;
}

ContactLaw law_with_friction(double degrees) {
    ContactParameters contact = augig_contact();
    contact.friction_angle = degrees * degree;
    return make_contact_law(contact, LawVariant::consistent);
}

// --- gravity ---------------------------------------------------------------------------------------------------------

// v = g t and v0 + t: the scheme is exact in v(n − ½) = v0 + n g Δt but for round-off.
TEST(Program, LetsASpecimenFallAndFlyFreely) {
    ProgramRun fall(jittered_grid(3, 4, 0.02, 0.03, 0.2), R"(
        name = "fall"
        gravity = ["1 m/s2", "-9.81 m/s2"]
        stages = ["fall"]
        initial.all.velocity = ["0.5 m/s", "0 m/s"]
        stage.fall.until.time = "20 us"
    )",
                    augig_law());
    fall.go(20);
    const double t = fall.run.state.time;
    EXPECT_GE(t, 20e-6);
    const Vector2 v = fall.run.mean(fall.run.state.velocity);
    verify("dynamics: free fall, speed over g t", v.y / (-gravity_on_earth * t), 1, 1e-12, "v = g t");
    expect_close(v.x, 0.5 + t, 1e-12, 0.5);
    EXPECT_LT(fall.residual(), 1e-12);
    EXPECT_GT(fall.energies.back().kinetic, 0.0);
}

// The work is ½ m v², to round-off; the distance v over the time after the ramp and half of it before, to the midpoint rule.
TEST(Program, GivesDrivenNodesTheirKineticEnergy) {
    ProgramRun pushed(jittered_grid(3, 4, 0.02, 0.03, 0.2), R"(
        name = "push"
        stages = ["push"]
        boundary.all = { box = ["-1 m", "1 m", "-1 m", "1 m"], velocity_x = { to = "2 m/s", over = "10 us" }, velocity_y = 0.0 }
        stage.push.until.time = "20 us"
    )",
                      augig_law(), PlaneCondition::strain, 0.8);
    pushed.go(20);
    const double energy = 0.5 * pushed.run.mass() * 4;
    verify("dynamics: work on a mass that is driven over its kinetic energy", pushed.energies.back().external / energy, 1, 1e-12,
           "m v^2/2");
    expect_close(pushed.energies.back().kinetic, energy, 1e-12, energy);
    expect_close(pushed.run.mean(pushed.run.state.displacement).x, 2 * (pushed.run.state.time - 5e-6), 1e-3, 2e-5);
    EXPECT_EQ(pushed.energies.back().damping, 0);
}

// σ = ρ g (h/2 − y): linear, and the mean of triangles over a circle that lies evenly about y is exact; to 0.1 % of the stress at
// the foot and 1e-6 of the weight.
TEST(Program, LetsAColumnCarryItsWeight) {
    const double height = 0.1;
    ProgramRun column(crossed_blocks(4, 16, 0.025, height, [](int, int) { return 0; }), R"(
        name = "column"
        gravity = ["0 m/s2", "-9.81 m/s2"]
        stages = ["settle"]
        boundary.floor = { on = "bottom", velocity_y = 0.0 }
        probe.low.circle = ["0 mm", "-31.25 mm", "6 mm"]
        probe.middle.circle = ["0 mm", "0 mm", "6 mm"]
        probe.high.circle = ["0 mm", "31.25 mm", "6 mm"]
        stage.settle.until = { time = "20 ms", rest = 1e-9 }
    )",
                      augig_law(), PlaneCondition::strain, 0.8);
    column.go(100);
    EXPECT_EQ(column.stage_controller.records().at(0).ended_by, "rest");
    const double foot = rock_of_programs.density * gravity_on_earth * height;
    for (const auto& [probe, y] : {std::pair{"low", -0.03125}, {"middle", 0.0}, {"high", 0.03125}}) {
        verify(std::string("dynamics: column under its weight, axial stress at y = ") + std::to_string(1000 * y).substr(0, 6) +
                   " mm over that of the foot",
               column.column(probe, "stress_yy").back() / foot, -(0.5 - y / height), 1e-3, "rho g (h/2 - y)", 1);
    }
    verify("dynamics: column under its weight, reaction over weight", column.column("floor", "force_y").back() / (foot * 0.025),
           1, 1e-6, "weight");
    EXPECT_LT(column.residual(), 1e-3);
}

// --- tractions -------------------------------------------------------------------------------------------------------

// σ = (2, −3, 0.5) MPa as tractions on four sides, from which the mean stress follows; contacts take no part in it, but their
// opening moves the points of the tractions by the strain, 1e-4. Dead ones turn the strained body a little for ever: 4e-6 of the
// forces.
TEST(Program, MeasuresAUniformStressInCircles) {
    ProgramRun patch(jittered_grid(6, 6, 0.03, 0.03, 0.25), R"(
        name = "patch"
        stages = ["load"]
        boundary.right = { on = "right", traction_x = "2 MPa", traction_y = "0.5 MPa" }
        boundary.left = { on = "left", traction_x = "-2 MPa", traction_y = "-0.5 MPa" }
        boundary.top = { on = "top", traction_x = "0.5 MPa", pressure = { to = "3 MPa", over = "5 ms" } }
        boundary.bottom = { on = "bottom", traction_x = "-0.5 MPa", pressure = { to = "3 MPa", over = "5 ms" } }
        probe.all.circle = [0, 0, "30 mm"]
        probe.core.circle = [0, 0, "8 mm"]
        probe.from.point = ["-9 mm", "-6 mm"]
        probe.to.point = ["8 mm", "-2 mm"]
        probe.gauge.gauge = ["-9 mm", "-6 mm", "8 mm", "-2 mm"]
        stage.load.until = { time = "10 ms", rest = 1e-5 }
    )",
                     augig_law(), PlaneCondition::stress, 0.8);
    patch.go(100);
    EXPECT_EQ(patch.stage_controller.records().at(0).ended_by, "rest");
    EXPECT_GE(patch.stage_controller.records().at(0).end, 5e-3);  // at rest on the way too, as slowly as the pressure grows
    const auto all = [&](const char* name) { return patch.column("all", name).back() * 1e-6; };
    verify("elements: mean stress of a specimen under tractions, xx (MPa)", all("stress_xx"), 2, 1e-3, "mean stress theorem");
    verify("elements: mean stress of a specimen under tractions, yy (MPa)", all("stress_yy"), -3, 1e-3, "mean stress theorem");
    verify("elements: mean stress of a specimen under tractions, xy (MPa)", all("stress_xy"), 0.5, 1e-3, "mean stress theorem",
           3);
    EXPECT_EQ(all("stress_zz"), 0);
    EXPECT_NE(patch.column("core", "stress_xx").back(), patch.column("all", "stress_xx").back());
    const auto moved = [&](const char* u) { return patch.column("to", u).back() - patch.column("from", u).back(); };
    const double distance = std::hypot(0.017 + moved("displacement_x"), 0.004 + moved("displacement_y"));
    EXPECT_NEAR(patch.column("gauge", "elongation").back(), distance - std::hypot(0.017, 0.004), 1e-17);
    verify("elements: force of a pressure along its part (kN/m)", patch.column("top", "force_y").back() * 1e-3, -90, 1e-3,
           "pressure x length");
    EXPECT_LT(patch.residual(), 1e-3);
}

// --- a block on a slope ----------------------------------------------------------------------------------------------

/// Acceleration of a block down a slope: it settles, damped, on a slope where it sticks; then it loses its damping and all
/// friction but the wanted. Its joint is soft against it, so that it slides as a rigid one: an elastic block that slides on a
/// stiff joint without damping begins to chatter, leaves the joint for moments, and is braked less (measured: by up to a half).
double acceleration_down(double slope, double friction) {
    constexpr double softness = 1e-4;
    constexpr double sticks = 60;
    const auto law = [&](double degrees) {
        ContactLaw soft = law_with_friction(degrees);
        soft.stiffest_normal = soft.kt *= softness;
        soft.ks *= softness;
        return soft;
    };
    const double a = slope * degree;
    ProgramRun block(two_blocks(8, 1, 0.04, 0.01),
                     fmt::format(R"(
        name = "slope"
        gravity = [{}, {}]
        stages = ["settle"]
        boundary.base = {{ on = "bottom", velocity_x = 0.0, velocity_y = 0.0 }}
        stage.settle.until = {{ time = "20 ms", rest = 1e-7 }}
    )",
                                 gravity_on_earth * std::sin(a), -gravity_on_earth * std::cos(a)),
                     law(sticks), PlaneCondition::strain, 0.8, 0.5);
    block.go(100);
    EXPECT_EQ(block.stage_controller.records().at(0).ended_by, "rest");
    block.run.parameters.laws = law(friction);
    block.run.parameters.damping = 0;
    const auto speed_after = [&](double duration) {
        const double end = block.run.state.time + duration;
        while (block.run.state.time < end) block.go_on(10);
        return mean_of_grain(block.run, block.run.state.velocity, 1).x;
    };
    const double before = speed_after(0.3e-3);
    const double begin = block.run.state.time;
    const double after = speed_after(1e-3);
    return (after - before) / (block.run.state.time - begin);
}

// a = g (sin α − cos α tan φ), or none where it sticks, to 0.5 % of a or g.
TEST(Program, LetsABlockSlideDownASlope) {
    const std::string source = "g (sin a - cos a tan phi)";
    verify("dynamics: block on a slope of 30 deg, friction 20 deg (m/s2)", acceleration_down(30, 20), 1.812815, 5e-3, source);
    verify("dynamics: block on a slope of 35 deg, friction 30 deg (m/s2)", acceleration_down(35, 30), 0.987266, 5e-3, source);
    verify("dynamics: block on a slope of 20 deg, friction 30 deg, over g", acceleration_down(20, 30), 0, 5e-3, "it sticks",
           gravity_on_earth);
}

// --- a joint in shear ------------------------------------------------------------------------------------------------

// Whatever its distribution, the friction of points that all slide is tan φ times the whole normal force, to 0.5 %.
TEST(Program, ShearsAJointAtItsFriction) {
    const double width = 0.04;
    const double phi = 30;
    const ContactLaw law = law_with_friction(phi);
    ProgramRun joint(two_blocks(8, 1, width, 0.01), R"(
        name = "joint"
        stages = ["press", "forth", "back"]
        boundary.base = { on = "bottom", velocity_x = 0.0, velocity_y = 0.0 }
        boundary.press = { on = "top" }
        boundary.push = { on = "top" }
        [stage.press]
        press.pressure = { to = "10 MPa", over = "50 us" }
        until = { time = "1 ms", rest = 1e-5 }
        [stage.forth]
        push.velocity_x = { to = "50 mm/s", over = "50 us" }
        until = { time = "1 ms", push.displacement_x = "20 um" }
        [stage.back]
        push.velocity_x = { to = "-50 mm/s", over = "50 us" }
        until = { time = "2 ms", push.displacement_x = "-20 um" }
    )",
                     law, PlaneCondition::strain, 0.8);
    joint.go(50);
    const std::vector<StageRecord>& records = joint.stage_controller.records();
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0].ended_by, "rest");
    for (const std::size_t stage : {1, 2}) EXPECT_EQ(records[stage].ended_by, "push.displacement_x");
    const std::vector<double>& force = joint.column("push", "force_x");
    const std::vector<double>& time = joint.history[HistoryColumn::time];
    const double limit = 10e6 * width * std::tan(phi * degree);
    const auto at = [&](double t) { return force[std::lower_bound(time.begin(), time.end(), t) - time.begin()]; };
    verify("specimens: joint in shear, force forth over normal force", at(records[1].end) / (10e6 * width),
           std::tan(phi * degree), 5e-3, "tan phi");
    verify("specimens: joint in shear, force back over normal force", force.back() / (10e6 * width), -std::tan(phi * degree),
           5e-3, "tan phi");
    EXPECT_GT(joint.energies.back().friction, 0.5 * limit * 30e-6);
    EXPECT_LT(joint.residual(), 5e-3);
}

// --- waves -----------------------------------------------------------------------------------------------------------

constexpr double bar_length = 0.2;

struct Wave {
    double speed, peak_velocity, end_velocity, back_velocity;
    double residual;
};

/// A pulse of 1 MPa and 8 µs at the left end of a bar of one grain; the right end free or held.
Wave wave(const std::string& sides, PlaneCondition plane, const Rock& of, const std::string& pulse, const std::string& component,
          const std::string& end) {
    const std::string text = fmt::format(R"(
        name = "wave"
        stages = ["run"]
        {}
        boundary.source = {{ on = "left", {} }}
        {}
        probe.first.point = ["-60 mm", 0]
        probe.second.point = ["60 mm", 0]
        probe.end.point = ["100 mm", 0]
        stage.run.until.time = "150 us"
    )",
                                         sides, pulse, end);
    ProgramRun bar(crossed_blocks(200, 1, bar_length, bar_length / 200, [](int, int) { return 0; }), text, augig_law(), plane, 0,
                   0.8, of);
    bar.go(4);
    const std::vector<double>& t = bar.history[HistoryColumn::time];
    const auto of_probe = [&](const std::string& name) { return bar.column(name, "velocity_" + component); };
    // The first passage ends before the reflection arrives: 160 mm and back at most at 3360 m/s.
    const auto centre = [&](const std::vector<double>& v, double from, double to) {
        double sum = 0, moment = 0;
        for (std::size_t i = 0; i < t.size(); ++i) {
            if (t[i] > from && t[i] < to) {
                sum += v[i] * v[i];
                moment += v[i] * v[i] * t[i];
            }
        }
        return moment / sum;
    };
    const auto extreme = [&](const std::vector<double>& v, double from, double to) {
        double best = 0;
        for (std::size_t i = 0; i < t.size(); ++i) {
            best = t[i] > from && t[i] < to && std::abs(v[i]) > std::abs(best) ? v[i] : best;
        }
        return best;
    };
    const double c = component == "x" ? 3300.0 : 1989.0;
    const double pass_first = 0.04 / c + 4e-6;
    const double pass_second = 0.16 / c + 4e-6;
    const double pass_back = 0.24 / c + 4e-6;
    constexpr double window = 10e-6;
    Wave w{};
    w.speed = 0.12 / (centre(of_probe("second"), pass_second - window, pass_second + window) -
                      centre(of_probe("first"), pass_first - window, pass_first + window));
    w.peak_velocity = extreme(of_probe("second"), pass_second - window, pass_second + window);
    w.back_velocity = extreme(of_probe("second"), pass_back - window, pass_back + window);
    w.end_velocity = extreme(of_probe("end"), 0, 150e-6);
    w.residual = bar.residual();
    return w;
}

// Speeds √((λ + 2μ)/ρ), √(E/(ρ (1 − ν²))), √(E/ρ), √(G/ρ) and σ/(ρ c), reflections at free and held ends; cells of 1 mm disperse
// a pulse of 27 mm by (π/27)²/24 = 6e-4.
TEST(Program, SendsWavesThatAreReflected) {
    const std::string rollers = "boundary.sides = { box = [\"-1 m\", \"1 m\", \"-1 m\", \"1 m\"], velocity_y = 0.0 }";
    const std::string push = "pressure = { pulse = \"1 MPa\", over = \"8 us\" }";
    const double cp = 3359.56;
    const Wave strain = wave(rollers, PlaneCondition::strain, rock_of_programs, push, "x", "");
    verify("dynamics: P wave, plane strain (m/s)", strain.speed, cp, 5e-3, "sqrt((lambda + 2 mu)/rho)");
    verify("dynamics: P wave, velocity over stress (m/s)", strain.peak_velocity, 1e6 / (rock_of_programs.density * cp), 1e-2,
           "sigma/(rho c)");
    verify("dynamics: P wave, velocity at a free end over that of the wave", strain.end_velocity / strain.peak_velocity, 2, 1e-2,
           "free end");
    verify("dynamics: P wave, reflected at a free end over incident", strain.back_velocity / strain.peak_velocity, 1, 1e-2,
           "free end: same velocity, opposite stress");
    EXPECT_LT(strain.residual, 1e-3);

    const Wave stress = wave(rollers, PlaneCondition::stress, rock_of_programs, push, "x", "");
    verify("dynamics: P wave, plane stress (m/s)", stress.speed, 3206.19, 5e-3, "sqrt(E/(rho (1 - nu^2)))");

    Rock without = rock_of_programs;
    without.poisson_ratio = 0;
    const Wave bar = wave("", PlaneCondition::stress, without, push, "x", "boundary.wall = { on = \"right\", velocity_x = 0.0 }");
    verify("dynamics: wave in a bar (m/s)", bar.speed, 3120.23, 5e-3, "sqrt(E/rho)");
    verify("dynamics: wave in a bar, reflected at a held end over incident", bar.back_velocity / bar.peak_velocity, -1, 1e-2,
           "held end: opposite velocity, same stress");
    EXPECT_EQ(bar.end_velocity, 0);

    const std::string slide = "boundary.sides = { box = [\"-1 m\", \"1 m\", \"-1 m\", \"1 m\"], velocity_x = 0.0 }";
    const Wave shear =
        wave(slide, PlaneCondition::strain, rock_of_programs, "traction_y = { pulse = \"1 MPa\", over = \"8 us\" }", "y", "");
    verify("dynamics: S wave (m/s)", shear.speed, 1989.39, 5e-3, "sqrt(G/rho)");
    verify("dynamics: S wave, velocity over stress (m/s)", shear.peak_velocity, 1e6 / (rock_of_programs.density * 1989.39), 1e-2,
           "tau/(rho c)");
}

// --- energy balance ----------------------------------------------------------------------------------------------------------

// Everything at once, through failure: driven corners, a follower pressure, a dead traction, gravity, a start in motion.
const char* const everything = R"(
    name = "everything"
    gravity = ["0 m/s2", "-1000 m/s2"]
    stages = ["load", "break", "let go"]
    boundary.floor = { on = "bottom", velocity_y = 0.0 }
    boundary.roof = { on = "top", velocity_y = 0.0, velocity_x = { sine = "0.2 m/s", frequency = "20 kHz" } }
    boundary.sides = { on = ["left", "right"] }
    initial.top = { box = ["-1 m", "1 m", 0, "1 m"], velocity = ["0.1 m/s", "-0.05 m/s"] }
    [stage.load]
    sides = { pressure = { to = "2 MPa", over = "40 us" }, traction_y = { times = [0, "30 us"], values = [0, "0.3 MPa"] } }
    until.time = "50 us"
    [stage.break]
    roof.velocity_y = { to = "-1 m/s", over = "30 us" }
    sides.shear = { to = "0.2 MPa", over = "40 us" }
    until = { time = "400 us", tensile_cracks = 10 }
    [stage."let go"]
    roof.velocity_x = "free"
    roof.velocity_y = "free"
    until.time = "100 us"
)";
ProgramRun everything_at_once(double damping) {
    ProgramRun run(jittered_grid(6, 8, 0.02, 0.03, 0.25), everything, augig_law(LawVariant::consistent), PlaneCondition::strain,
                   damping);
    run.go(20);
    return run;
}

// Each term by its own definition, to the steps in which contacts fail.
TEST(Program, ClosesTheEnergyBalanceOfEveryForce) {
    for (const double damping : {0.0, 0.8}) {
        const ProgramRun all = everything_at_once(damping);
        ASSERT_EQ(all.stage_controller.records().size(), 3U);
        EXPECT_EQ(all.stage_controller.records()[1].ended_by, "tensile_cracks");
        EXPECT_GT(all.run.failed_points(), 10U);
        EXPECT_GT(all.energies.back().external, 0.0);
        verify("specimens: residual of the energy balance over stored energy, a program with every force", all.residual(), 0,
               2e-3, "each term by its own definition", 1);
    }
}

}  // namespace
}  // namespace graincrack::test
