// How platens and pressure move in the four tests.
#include "solver/loading/standard_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "share/error.hpp"
#include "solver/setup/test_boundary.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

using test::expect_close;

Specimen specimen() { return test::one_diagonal_grid(4, 8, 0.04, 0.08); }
const double transit = 0.08 / std::sqrt(25.8e9 / 2650);  // of a bar wave

Loading loading_of(const LoadingRequest& r) { return {r, specimen(), test::augig_granite().rock, PlaneCondition::strain}; }

TEST(Loading, StartsSmoothlyAndKeepsItsSpeed) {
    LoadingRequest request;
    request.platen_speed = 5e-3;
    Loading loading = loading_of(request);
    EXPECT_FALSE(loading.is_isotropic());
    const double dt = 0.25 * transit;
    double speed = 0;
    for (int i = 0; i < 80; ++i) {
        const IntervalLoading b = loading.next({i * dt, 0, 0}, dt);
        EXPECT_EQ(b.velocity_begin[bottom_platen], speed);  // no jump between batches
        EXPECT_EQ(b.velocity_begin[top_platen], -speed);
        EXPECT_GE(b.velocity_end[bottom_platen], speed);
        EXPECT_EQ(b.velocity_end[top_platen], -b.velocity_end[bottom_platen]);
        EXPECT_EQ(b.pressure_end, 0);
        speed = b.velocity_end[bottom_platen];
        EXPECT_EQ(loading.platen_speed(), speed);
        if ((i + 1) * dt >= 10 * transit) {
            EXPECT_EQ(speed, 5e-3);
        } else {
            EXPECT_LT(speed, 5e-3);
        }
    }
}

TEST(Loading, TensionPulls) {
    LoadingRequest request;
    request.test = TestKind::tension;
    Loading loading = loading_of(request);
    const IntervalLoading b = loading.next({}, transit);
    EXPECT_LT(b.velocity_end[bottom_platen], 0);
    EXPECT_GT(b.velocity_end[top_platen], 0);
}

TEST(Loading, PressureFirstThenPlatens) {
    LoadingRequest request;
    request.test = TestKind::triaxial;
    request.confining_pressure = 4e6;
    Loading loading = loading_of(request);
    EXPECT_TRUE(loading.is_isotropic());
    const double dt = transit;
    double time = 0;
    double pressure = 0;
    for (int i = 0; i < 10000 && loading.is_isotropic(); ++i) {
        const IntervalLoading b = loading.next({time, pressure, 0}, dt);  // a specimen that follows at once
        EXPECT_GE(b.pressure_end, pressure);
        EXPECT_LE(b.pressure_end, 4e6);
        EXPECT_GT(b.pressure_end + b.velocity_end[bottom_platen], 0);
        pressure = b.pressure_end;
        time += dt;
    }
    EXPECT_FALSE(loading.is_isotropic());
    EXPECT_EQ(pressure, 4e6);
    EXPECT_GT(loading.isotropic_end_time(), 10 * transit);
    for (int i = 0; i < 30; ++i, time += dt) {
        EXPECT_EQ(loading.next({time, 5e6, 0}, dt).pressure_begin, 4e6);
    }
    EXPECT_EQ(loading.platen_speed(), request.platen_speed);
}

TEST(Loading, AutomaticFollowsTheMeasuresInTheSenseOfTheTest) {
    for (const TestKind test : {TestKind::uniaxial, TestKind::tension}) {
        LoadingRequest request;
        request.test = test;
        request.rate = RateKind::automatic;
        Loading loading = loading_of(request);
        const double sense = test == TestKind::tension ? -1 : 1;
        const double time_step = 1e-7;
        double time = 0;
        double travel = 0;
        for (int i = 0; i < 50; ++i) {
            const std::int64_t steps = loading.interval_steps(time_step);
            EXPECT_GE(steps, 20);
            EXPECT_LE(static_cast<double>(steps) * time_step, 0.5 * transit);
            const double duration = static_cast<double>(steps) * time_step;
            const IntervalLoading b = loading.next({time, 0, 0, {.stored_energy = 100}}, duration);
            EXPECT_GT(sense * b.velocity_end[bottom_platen], 0);
            EXPECT_EQ(b.velocity_end[top_platen], -b.velocity_end[bottom_platen]);
            travel += 0.5 * (b.velocity_begin[bottom_platen] + b.velocity_end[bottom_platen]) * duration;
            time += duration;
        }
        expect_close(loading.mean_speed(time), sense * travel / time, 1e-12, std::abs(travel / time));
    }
}

TEST(Loading, BlocksRestBetweenThem) {
    LoadingRequest request;
    request.rate = RateKind::blocks;
    request.block_steps = 100;
    request.rate_tolerance = 1e-4;
    Loading loading = loading_of(request);
    EXPECT_EQ(loading.interval_steps(1e-7), 20);
    for (int block = 0; block < 3; ++block) {
        double travel = 0;
        for (int part = 0; part < 5; ++part) {
            const IntervalLoading b = loading.next({0, 0, part == 0 ? 1e-5 : 1.0}, 2e-6);
            travel += 0.5 * (b.velocity_begin[bottom_platen] + b.velocity_end[bottom_platen]) * 2e-6;
        }
        expect_close(travel, 4 * 2e-6 * request.platen_speed, 1e-12, travel);  // one part of five is start and stop
        EXPECT_EQ(loading.next({0, 0, 1.0}, 2e-6).velocity_end[bottom_platen], 0);
    }
}

TEST(Loading, TheLongestWayIsAsLongAsAtTheSlowestSpeed) {
    LoadingRequest request;
    request.max_strain = 0.01;
    const double travel = 0.5 * 0.01 * 0.08;
    EXPECT_NEAR(static_cast<double>(loading_of(request).longest(1e-7).steps), travel / 5e-3 / 1e-7, 1);  // rounded down
    request.rate = RateKind::blocks;
    EXPECT_NEAR(static_cast<double>(loading_of(request).longest(1e-7).steps), travel / (0.8 * 5e-3) / 1e-7, 1);
    request.rate = RateKind::automatic;
    request.rate_tolerance = 1e-3;
    const std::int64_t slow = loading_of(request).longest(1e-7).steps;
    request.rate_tolerance = 2e-3;
    expect_close(static_cast<double>(slow), 2.0 * static_cast<double>(loading_of(request).longest(1e-7).steps), 1e-3,
                 static_cast<double>(slow));
}

TEST(Loading, GivesUpOnASpecimenThatDoesNotSettle) {
    LoadingRequest request;
    request.test = TestKind::triaxial;
    request.confining_pressure = 4e6;
    Loading loading = loading_of(request);
    EXPECT_THROW(
        {
            for (int i = 0; i < 100000; ++i) {
                static_cast<void>(loading.next({i * transit, 1e6, 1}, transit));
            }
        },
        NumericalError);
}

TEST(Loading, SupportsOfTheTests) {
    const Specimen s = specimen();
    const Assemblage a = make_assemblage(s, test::augig_granite().rock, PlaneCondition::strain);
    const ContactParameters contact = test::augig_contact();
    LoadingRequest request;
    request.platen_friction = 5 * test::degree;
    const Boundary uniaxial = make_test_boundary(a, s, request, contact);
    EXPECT_TRUE(uniaxial.membrane_edges.empty());
    EXPECT_EQ(uniaxial.platens[top_platen].position, 0.04);
    EXPECT_EQ(uniaxial.platens[bottom_platen].side, -1);
    EXPECT_EQ(uniaxial.platens[top_platen].normal_stiffness, contact.normal_stiffness);
    expect_close(uniaxial.platens[top_platen].tan_friction, 0.0874887, 1e-6, 1);  // tan 5°
    EXPECT_FALSE(uniaxial.platens[top_platen].bonded);
    request.confining_pressure = 4e6;
    EXPECT_EQ(make_test_boundary(a, s, request, contact).membrane_edges.size(), 16U);
    request = {};
    request.test = TestKind::tension;
    const Boundary tension = make_test_boundary(a, s, request, contact);
    EXPECT_TRUE(tension.platens[top_platen].bonded);
    EXPECT_EQ(tension.platens[top_platen].shear_stiffness, 0);
    EXPECT_EQ(name_of(TestKind::brazilian), "brazilian");
}

}  // namespace
}  // namespace graincrack
