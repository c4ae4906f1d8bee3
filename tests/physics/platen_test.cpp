// Platens and membrane: a block that bounces, friction that slips, a pressure that presses.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/setup/regions.hpp"
#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_law;
using test::expect_close;
using test::LinearPressure;
using test::SmallRun;
using test::verify;
using test::with_pressure;

/// One grain of two triangles, 20 × 20 mm.
Specimen block() {
    return test::specimen_of_grains({{-0.01, -0.01}, {0.01, -0.01}, {0.01, 0.01}, {-0.01, 0.01}}, {{0, 1, 2}, {0, 2, 3}}, {0, 0});
}
std::vector<Platen> platens_at(double gap, double stiffness) {
    std::vector<Platen> platens(2);
    platens[bottom_platen].motion = bottom_platen;
    platens[bottom_platen].side = -1;
    platens[bottom_platen].position = -0.01 - gap;
    platens[top_platen].position = 1;  // out of reach
    for (Platen& p : platens) p.normal_stiffness = stiffness;
    return platens;
}

// A block on a penalty floor: π √(m/k) of contact, and the same speed back. The block's own compliance, 1/3 of k over E A/L
// here, adds 1e-4 of it.
TEST(Platen, ABlockBounces) {
    SmallRun run(block(), augig_law());
    run.set_boundary(make_boundary(run.assemblage, run.specimen, platens_at(1e-5, 1e8), 0.001), 0.2);
    double k = 0;  // of the floor's springs under the two lower corners, N/m per metre of thickness
    for (const PlatenPoint& point : run.boundary.platen_points) {
        k += run.assemblage.position[static_cast<std::size_t>(point.node)].y < 0 ? 1e8 * point.tributary : 0;
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
TEST(Platen, ThoseThatArePlacedMeetBothEndsOfASpecimenThatHasTurned) {
    SmallRun run(test::jittered_grid(4, 6, 0.02, 0.03, 0.2), augig_law());
    std::vector<Platen> platens(2);
    platens[bottom_platen].motion = bottom_platen;
    platens[bottom_platen].side = -1;
    platens[bottom_platen].position = -0.015;
    platens[top_platen].position = 0.015;
    run.set_boundary(make_boundary(run.assemblage, run.specimen, platens, 1e-4), 0.2);
    remove_platens(run.state);
    constexpr double angle = 2e-3;
    for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
        const Vector2& p = run.assemblage.position[i];
        run.state.displacement[i] = {1e-4 - angle * p.y, 3e-4 + angle * p.x};
    }
    place_platens(run.assemblage, run.boundary, run.state);
    ASSERT_FALSE(run.state.platen_points.empty());
    for (const PlatenPoint& point : run.state.platen_points) {
        const double moved = run.state.displacement[static_cast<std::size_t>(point.node)].y;
        expect_close(point.gap + (point.platen == bottom_platen ? -moved : moved), 0, angle * angle * 0.03, 1);
    }
}

TEST(Platen, TheMembraneExertsPressureTimesLength) {
    SmallRun run(test::jittered_grid(4, 6, 0.02, 0.03, 0.2), augig_law());
    run.press_on({BoundaryPart::left, BoundaryPart::right}, 0.5);
    run.parameters.damping = 0.8;
    run.begin();
    const double pressure = 4e6;
    LinearPressure membrane;
    run.steps_under(membrane, pressure, 3000);
    run.steps_under(membrane, pressure, 3000);
    const Measurement m = run.measured();
    // Free to lengthen along y: by ν(1 + ν) p/E of its height, 5e-5.
    verify("dynamics: force of the membrane (N)", m.confining_force, pressure * run.specimen.height, 2e-4,
           "pressure times height");
    double area = 0;
    double xx = 0;
    double yy = 0;
    const Frame frame = run.frame();
    for (std::size_t e = 0; e < frame.element_stress.size(); ++e) {
        const double a = run.assemblage.element_geometry[e].area;
        area += a;
        xx += a * frame.element_stress[e][0];
        yy += a * frame.element_stress[e][1];
    }
    // Mean stress of grains and contacts in equilibrium, contacts' share of the area being none.
    verify("dynamics: mean stress under a membrane (MPa)", xx / area * 1e-6, -pressure * 1e-6, 5e-3, "its pressure");
    expect_close(yy / area, 0, 5e-3, pressure);
    EXPECT_GT(m.energies.external, 0);
    expect_close(m.energies.balance_error(), 0, 1e-3, m.energies.stored());
}

}  // namespace
}  // namespace graincrack
