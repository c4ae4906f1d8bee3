// Platens and membrane: a block that bounces, a pressure that presses; punches, rollers and platens along another direction.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/setup/regions.hpp"
#include "tests/support/check.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

// A block on a penalty floor: π √(m/k) of contact, and the same speed back. The block's own compliance, 1/3 of k over E A/L
// here, adds 1e-4 of it.
TEST(Platen, LetsABlockBounceAsASpring) {
    SmallRun run(one_diagonal_column(1, 0.02, 0.02), augig_law());
    std::vector<Platen> platens = two_platens(-0.01 - 1e-5, 1);  // the upper one out of reach
    for (Platen& p : platens) p.normal_stiffness = 1e8;
    run.set_boundary(make_boundary(run.assemblage, run.specimen, platens, 0.001), 0.2);
    double k = 0;  // of the floor's springs under the two lower corners, N/m per metre of thickness
    for (const PlatenPoint& point : run.boundary.platen_points) {
        k += run.assemblage.position[point.node].y < 0 ? 1e8 * point.tributary : 0;
    }
    ASSERT_GE(k, 1e8 * 0.02);
    const double speed = 0.1;
    run.set_velocity([&](const Vector2&) { return Vector2{0, -speed}; });
    run.begin();
    std::int64_t steps_in_contact = 0;
    double largest = 0;
    for (int i = 0; i < 40000 && (steps_in_contact == 0 || run.measured().force_bottom > 0); ++i) {
        run.steps(1);
        const double force = run.measured().force_bottom;
        steps_in_contact += force > 0 ? 1 : 0;
        largest = std::max(largest, force);
    }
    ASSERT_GT(steps_in_contact, 1000);
    const double expected = std::numbers::pi * std::sqrt(run.mass() / k);
    verify("dynamics: block on a penalty floor, contact time (s)",
           static_cast<double>(steps_in_contact) * run.parameters.time_step, expected, 1e-3, "pi sqrt(m/k)");
    verify("dynamics: block on a penalty floor, speed after (m/s)", run.mean(run.state.velocity).y, speed, 1e-3, "that before");
    expect_close(run.mean(run.state.velocity).x, 0, 1e-3, speed);
    expect_close(largest, speed * std::sqrt(k * run.mass()), 2e-3, largest);  // and with the force of that spring
    const Energies e = run.measured().energies;
    expect_close(e.balance_error() + 0.5 * run.mass() * speed * speed, 0, 1e-6, e.kinetic);
}

// What is turned by an angle a as a whole lacks a²/2 of its size where the platens, inclined by a, are.
TEST(Platen, MeetsTheEndOfASpecimenThatHasTurned) {
    SmallRun run(jittered_grid(4, 6, 0.02, 0.03, 0.2), augig_law());
    run.set_boundary(make_boundary(run.assemblage, run.specimen, two_platens(-0.015, 0.015), 1e-4), 0.2);
    remove_platens(run.state);
    constexpr double angle = 2e-3;
    for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
        const Vector2& p = run.assemblage.position[i];
        run.state.displacement[i] = {1e-4 - angle * p.y, 3e-4 + angle * p.x};
    }
    place_platens(run.assemblage, run.boundary, run.state);
    ASSERT_FALSE(run.state.platen_points.empty());
    for (const PlatenPoint& point : run.state.platen_points) {
        const double moved = run.state.displacement[point.node].y;
        expect_close(point.gap + (point.platen == bottom_platen ? -moved : moved), 0, angle * angle * 0.03, 1);
    }
}

// The force is p h, to the elongation along y, ν(1 + ν) p/E of it = 5e-5; the mean stress of grains and contacts in equilibrium
// is −p, and none along y, to 0.5 %.
TEST(Membrane, ExertsPressureTimesLength) {
    SmallRun run(jittered_grid(4, 6, 0.02, 0.03, 0.2), augig_law());
    run.press_on({BoundaryPart::left, BoundaryPart::right}, 0.5);
    run.parameters.damping = 0.8;
    run.begin();
    const double pressure = 4e6;
    LinearPressure membrane;
    run.steps_under(membrane, pressure, 3000);
    run.steps_under(membrane, pressure, 3000);
    const Measurement m = run.measured();
    verify("dynamics: force of the membrane (N)", m.confining_force, pressure * run.specimen.height, 2e-4,
           "pressure times height");
    double area = 0, xx = 0, yy = 0;
    const Frame frame = run.frame();
    for (std::size_t e = 0; e < frame.element_stress.size(); ++e) {
        const double a = run.assemblage.element_geometry[e].area;
        area += a;
        xx += a * frame.element_stress[e][0];
        yy += a * frame.element_stress[e][1];
    }
    verify("dynamics: mean stress under a membrane (MPa)", xx / area * 1e-6, -pressure * 1e-6, 5e-3, "its pressure");
    expect_close(yy / area, 0, 5e-3, pressure);
    EXPECT_GT(m.energies.external, 0);
    expect_close(m.energies.balance_error(), 0, 1e-3, m.energies.stored());
}

// --- platens by part -------------------------------------------------------------------------------------------------------

/// Pushes for 20 µs and waits until the specimen is at rest: what the nodes of a mean force are short of balance is 1e-6 of it,
/// together at most their number times that, and less than that of a load that many of them bear.
std::string push_and_wait(const std::string& platens) {
    return R"(
        name = "push"
        stages = ["push", "wait"]
        [platens]
        max_strain = 0.02
    )" + platens +
           R"(
        [stage.push]
        platen_speed = "0.02 m/s"
        until.time = "20 us"
        [stage.wait]
        platen_speed = "0 m/s"
        until.time = "4 ms"
        until.rest = 1e-6
    )";
}

/// Forces of the faces of platens along their axis, N, in their order.
std::vector<double> roller_forces(const SmallRun& run, double* moment = nullptr) {
    std::vector<double> forces(run.boundary.platens.size(), 0.0);
    for (const PlatenPoint& point : run.state.platen_points) {
        const Platen& platen = run.boundary.platens[point.platen];
        const Vector2 u = run.state.displacement[point.node];
        const PlatenResponse r = platen_response(platen, point, u, run.state.loading.platen_displacement[platen.motion]);
        forces[point.platen] += dot(r.force, platen.axis);
        if (moment != nullptr) *moment += (run.assemblage.position[point.node].x + u.x) * r.force.y;
    }
    return forces;
}

// A punch has nodes within its width alone, and its force is that of the platen opposite, to rest.
TEST(Roller, MeetsWhatLiesBeforeItOnly) {
    ProgramRun program(jittered_grid(16, 8, 0.04, 0.02, 0.2), push_and_wait(R"(
        [platens.top]
        on = "top"
        at = ["4 mm"]
        width = "10 mm"
    )"),
                       augig_law(), PlaneCondition::strain, 0.8);
    std::size_t below = 0;
    for (const PlatenPoint& point : program.run.boundary.platen_points) {
        const Vector2& position = program.run.assemblage.position[point.node];
        if (program.run.boundary.platens[point.platen].motion != top_platen) continue;
        ++below;
        EXPECT_LE(std::abs(position.x - 0.004), 0.005 + 1e-9);
        EXPECT_GT(position.y, 0.01 - 1e-9);
    }
    EXPECT_GE(below, 8U);
    program.go(50);
    const std::vector<double> forces = roller_forces(program.run);
    ASSERT_EQ(forces.size(), 2U);
    EXPECT_LT(forces[1], -1e3);
    expect_close(forces[0], -forces[1], 1e-3, forces[0]);  // 768 nodes
}

// Two rollers bear the load of a third by their arms, 40:30, to the places of contact within their width; forces and moments to
// rest.
TEST(Roller, BearsABeamByItsArm) {
    ProgramRun program(jittered_grid(40, 8, 0.1, 0.02, 0.2), push_and_wait(R"(
        [platens.bottom]
        at = ["-30 mm", "40 mm"]
        width = "5 mm"
        [platens.top]
        at = ["0 mm"]
        width = "5 mm"
    )"),
                       augig_law(), PlaneCondition::strain, 0.8);
    program.go(50);
    double moment = 0;
    const std::vector<double> forces = roller_forces(program.run, &moment);
    ASSERT_EQ(forces.size(), 3U);
    const double load = -forces[2];
    EXPECT_GT(load, 1e2);
    expect_close(forces[0] + forces[1], load, 2e-3, load);  // 1,920 nodes
    expect_close(moment, 0, 2e-3, 0.07 * load);
    expect_close(forces[0] / load, 40.0 / 70, 0.05, 1);
}

/// The specimen turned by 90° counter-clockwise.
Specimen turned_over(Specimen s) {
    for (auto& p : s.node_position) p = {-p[1], p[0]};
    std::swap(s.width, s.height);
    return s;
}

// The forces are the same, to rest.
TEST(Platen, AlongXPressesAsOneAlongYTheTurnedSpecimen) {
    const Specimen specimen = jittered_grid(8, 12, 0.02, 0.03, 0.2);
    const auto run = [](const Specimen& s, const std::string& platens) {
        ProgramRun program(s, push_and_wait(platens), augig_law(), PlaneCondition::strain, 0.8, 0.5, augig_granite().rock,
                           augig_contact(), 0.3);
        program.go(50);
        return roller_forces(program.run);
    };
    const std::vector<double> along_x = run(specimen, "direction = \"0 deg\"\n");
    const std::vector<double> along_y = run(turned_over(specimen), "");
    ASSERT_EQ(along_x.size(), 2U);
    EXPECT_LT(along_x[1], -1e3);
    for (std::size_t i = 0; i < 2; ++i) expect_close(along_x[i], along_y[i], 1e-3, along_y[i]);  // 576 nodes
}

// Beside the specimen, on a part that it has not, or without a width.
TEST(Roller, IsRefusedWhereItMeetsNothing) {
    const Specimen specimen = jittered_grid(8, 12, 0.02, 0.03, 0.2);
    EXPECT_THROW(ProgramRun(specimen, push_and_wait("[platens.top]\nat = [\"50 mm\"]\nwidth = \"1 mm\"\n"), augig_law()),
                 InputError);
    EXPECT_THROW(ProgramRun(specimen, push_and_wait("[platens.top]\non = \"roof\"\n"), augig_law()), InputError);
    EXPECT_THROW(ProgramRun(specimen, push_and_wait("[platens.top]\nat = [\"0 mm\"]\n"), augig_law()), InputError);
}

}  // namespace
}  // namespace graincrack::test
