// Platens by part: punches and rollers, and platens along another direction, by statics.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/check.hpp"
#include "tests/support/program_run.hpp"

namespace graincrack {
namespace {

using test::augig_law;
using test::expect_close;
using test::ProgramRun;

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
std::vector<double> roller_forces(const test::SmallRun& run, double* moment = nullptr) {
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

TEST(Roller, APunchMeetsWhatLiesBeforeItOnly) {
    ProgramRun program(test::jittered_grid(16, 8, 0.04, 0.02, 0.2), push_and_wait(R"(
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

TEST(Roller, ThreeRollersBearABeam) {
    ProgramRun program(test::jittered_grid(40, 8, 0.1, 0.02, 0.2), push_and_wait(R"(
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
    // By their arms, as far as the points of contact are those of the rollers' middles.
    expect_close(forces[0] / load, 40.0 / 70, 0.05, 1);
}

/// The specimen turned by 90° counter-clockwise.
Specimen turned_over(Specimen s) {
    for (auto& p : s.node_position) p = {-p[1], p[0]};
    std::swap(s.width, s.height);
    return s;
}

TEST(Roller, PlatensAlongXPressAsThoseAlongYPressTheTurnedSpecimen) {
    const Specimen specimen = test::jittered_grid(8, 12, 0.02, 0.03, 0.2);
    const auto run = [](const Specimen& s, const std::string& platens) {
        ProgramRun program(s, push_and_wait(platens), augig_law(), PlaneCondition::strain, 0.8, 0.5, test::augig_granite().rock,
                           test::augig_contact(), 0.3);
        program.go(50);
        return roller_forces(program.run);
    };
    const std::vector<double> along_x = run(specimen, "direction = \"0 deg\"\n");
    const std::vector<double> along_y = run(turned_over(specimen), "");
    ASSERT_EQ(along_x.size(), 2U);
    EXPECT_LT(along_x[1], -1e3);
    for (std::size_t i = 0; i < 2; ++i) expect_close(along_x[i], along_y[i], 1e-3, along_y[i]);  // 576 nodes
}

TEST(Roller, WhatMeetsNothingIsRefused) {
    const Specimen specimen = test::jittered_grid(8, 12, 0.02, 0.03, 0.2);
    EXPECT_THROW(ProgramRun(specimen, push_and_wait("[platens.top]\nat = [\"50 mm\"]\nwidth = \"1 mm\"\n"), augig_law()),
                 InputError);
    EXPECT_THROW(ProgramRun(specimen, push_and_wait("[platens.top]\non = \"roof\"\n"), augig_law()), InputError);
    EXPECT_THROW(ProgramRun(specimen, push_and_wait("[platens.top]\nat = [\"0 mm\"]\n"), augig_law()), InputError);
}

}  // namespace
}  // namespace graincrack
