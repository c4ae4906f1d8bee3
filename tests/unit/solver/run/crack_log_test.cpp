// The crack log, made from the events of a step.
#include "solver/run/crack_log.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

ContactEvent event(std::int64_t step, std::int32_t contact, std::uint8_t point) {
    return {.step = step,
            .contact = contact,
            .point = point,
            .mode = CrackMode::shear,
            .motion = {-1e-7, 2e-6},
            .peak_traction = {-3e6, -4e6},
            .tangent = {-1, 0},
            .position = {0.001, 0.002}};
}

TEST(CrackLog, SortsRowsByStepContactAndPoint) {
    SmallRun run(jittered_grid(12, 12, 0.02, 0.02, 0.2), augig_law());
    ASSERT_GE(run.state.events.size(), 3U);
    CrackLog crack_log(2 * run.assemblage.contacts.size());
    EXPECT_TRUE(crack_log.empty());
    run.state.events[2] = {event(5, 300, 0), event(6, 270, 1)};
    run.state.events[0] = {event(6, 7, 1), event(5, 9, 1)};
    run.state.events[1] = {event(5, 130, 0)};
    run.state.events[0][0].mode = CrackMode::tensile;
    run.state.fracture_energy[2 * 130] = 0.25;
    crack_log.collect(run.assemblage, 1e-3, run.state);
    for (const auto& chunk : run.state.events) {
        EXPECT_TRUE(chunk.empty());
    }
    const std::vector<Crack> rows = crack_log.rows(run.assemblage, run.state.fracture_energy);
    ASSERT_EQ(rows.size(), 5U);
    const std::int32_t contacts[] = {9, 130, 300, 7, 270};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(rows[i].contact, contacts[i]);
        EXPECT_EQ(rows[i].step, i < 3 ? 5 : 6);
        expect_close(rows[i].time, i < 3 ? 5e-3 : 6e-3, 1e-15, 1e-3);
        EXPECT_TRUE(std::isnan(rows[i].separated.time));
        EXPECT_EQ(rows[i].length, run.assemblage.contacts[contacts[i]].point_area);
    }
    EXPECT_EQ(rows[1].energy_released, 0.25);
    EXPECT_EQ(crack_log.tensile_points(), 1U);
    EXPECT_EQ(crack_log.shear_points(), 4U);
    EXPECT_EQ(rows[3].mode, CrackMode::tensile);
    EXPECT_EQ(rows[0].orientation, 0);  // a direction, not a sense: π is 0
    expect_close(rows[0].mode_angle, std::atan2(4.0, -3.0), 1e-15, 1);
    EXPECT_EQ(rows[0].opening, -1e-7);
    EXPECT_EQ(rows[0].sliding, 2e-6);
    EXPECT_EQ(rows[0].position, (std::array<double, 2>{0.001, 0.002}));
}

// Damage, breaking and separation complete the row of a failure, whatever the order in which they arrive.
TEST(CrackLog, CompletesARowByLaterEvents) {
    SmallRun run(one_diagonal_grid(3, 3, 0.02, 0.02), augig_law());
    CrackLog crack_log(2 * run.assemblage.contacts.size());
    const auto later = [](std::int64_t step, ContactEventKind kind) {
        ContactEvent e = event(step, 4, 1);
        e.kind = kind;
        e.motion = {1e-6 * static_cast<double>(step), -2e-6};
        return e;
    };
    run.state.events[0] = {later(7, ContactEventKind::damaged_50), later(7, ContactEventKind::damaged_10), event(7, 4, 1)};
    crack_log.collect(run.assemblage, 1.0, run.state);
    Crack row = crack_log.rows(run.assemblage, run.state.fracture_energy).at(0);
    EXPECT_TRUE(std::isnan(row.broken.time) && std::isnan(row.broken.opening) && std::isnan(row.broken.sliding));
    EXPECT_TRUE(std::isnan(row.separated.time) && std::isnan(row.separated.opening) && std::isnan(row.separated.sliding));
    run.state.events[0] = {later(9, ContactEventKind::broken), later(11, ContactEventKind::separation)};
    crack_log.collect(run.assemblage, 1.0, run.state);
    ASSERT_EQ(crack_log.rows(run.assemblage, run.state.fracture_energy).size(), 1U);
    row = crack_log.rows(run.assemblage, run.state.fracture_energy)[0];
    EXPECT_EQ(row.damaged_10, (CrackMoment{7, 1e-6 * 7, -2e-6}));
    EXPECT_EQ(row.damaged_50, (CrackMoment{7, 1e-6 * 7, -2e-6}));
    EXPECT_EQ(row.broken, (CrackMoment{9, 1e-6 * 9, -2e-6}));
    EXPECT_EQ(row.separated, (CrackMoment{11, 1e-6 * 11, -2e-6}));
    EXPECT_EQ(row.opening, -1e-7);  // at failure, as before
    ContactEvent of_old_crack = later(12, ContactEventKind::separation);
    of_old_crack.contact = 5;  // a crack that was there before the run
    run.state.events[0] = {of_old_crack};
    crack_log.collect(run.assemblage, 1.0, run.state);
    EXPECT_EQ(crack_log.rows(run.assemblage, run.state.fracture_energy).size(), 1U);
}

// Two grains that are drawn apart and turned against each other, followed step by step: what a row has of the failure is of its
// step, what it has of a later moment of the step of that.
TEST(CrackLog, HasTheMotionsOfTheStepsItNames) {
    SmallRun run(one_diagonal_column(2, 0.02, 0.02), augig_law());
    run.set_velocity([](const Vector2&) { return Vector2{}; });
    for (std::int32_t i = 4; i < 8; ++i) run.state.velocity[i] = {1, 5 + 100 * run.assemblage.position[i].x};
    run.begin();
    CrackLog crack_log(2);
    struct Instant {
        std::array<ContactMotion, 2> motion;
        std::array<Vector2, 2> middle;
        double direction;
    };
    std::vector<Instant> instants;
    const auto& nodes = run.assemblage.contacts[0].nodes;
    const auto middle_of = [&](std::size_t a, std::size_t b) {
        const auto place = [&](std::int32_t i) { return run.assemblage.position[i] + run.state.displacement[i]; };
        return 0.5 * (place(nodes[a]) + place(nodes[b]));
    };
    for (int i = 0; i <= 600; ++i) {
        const Vector2 first = middle_of(0, 2);
        const Vector2 along = middle_of(1, 3) - first;
        instants.push_back({{ContactMotion{run.state.opening[0], run.state.sliding[0]},
                             ContactMotion{run.state.opening[1], run.state.sliding[1]}},
                            {first + 0.25 * along, first + 0.75 * along},
                            std::atan2(along.y, along.x)});
        run.steps(1);
    }
    crack_log.collect(run.assemblage, run.parameters.time_step, run.state);
    const std::vector<Crack> rows = crack_log.rows(run.assemblage, run.state.fracture_energy);
    ASSERT_EQ(rows.size(), 2U);
    const double dt = run.parameters.time_step;
    const double released = run.measured().energies.fracture_tension;
    EXPECT_GT(released, 0);
    expect_close(rows[0].energy_released + rows[1].energy_released, released, 1e-12, released);
    for (const Crack& row : rows) {
        const Instant& failure = instants.at(static_cast<std::size_t>(row.step));
        EXPECT_EQ(row.time, static_cast<double>(row.step) * dt);
        EXPECT_EQ(row.opening, failure.motion[row.point].opening);
        EXPECT_EQ(row.sliding, failure.motion[row.point].sliding);
        expect_close(row.position[0], failure.middle[row.point].x, 1e-15, 0.01);
        expect_close(row.position[1], failure.middle[row.point].y, 1e-15, 0.01);
        expect_close(std::remainder(row.orientation - failure.direction, std::numbers::pi), 0, 1e-14, 1);
        // The traction is of the step before, the last one short of the peak.
        const ContactMotion& before = instants.at(static_cast<std::size_t>(row.step) - 1).motion[row.point];
        const ContactLaw& law = run.parameters.laws[0];
        expect_close(row.mode_angle, std::atan2(law.ks * std::abs(before.sliding), law.kt * before.opening), 1e-12, 1);
        EXPECT_EQ(row.mode, CrackMode::tensile);
        EXPECT_EQ(row.length, 0.01);
        EXPECT_TRUE(row.damaged_10.time < row.damaged_50.time && row.damaged_50.time < row.broken.time &&
                    row.broken.time < row.separated.time);
        for (const CrackMoment& moment : {row.damaged_10, row.damaged_50, row.broken, row.separated}) {
            const auto step = static_cast<std::size_t>(std::lround(moment.time / dt));
            EXPECT_GT(moment.time, row.time);
            EXPECT_EQ(moment.opening, instants.at(step).motion[row.point].opening);
            EXPECT_EQ(moment.sliding, instants.at(step).motion[row.point].sliding);
        }
    }
}

}  // namespace
}  // namespace graincrack::test
