// Stages of programs and of the standard tests, told what their specimen answers.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "share/base/error.hpp"
#include "share/file/peak.hpp"
#include "solver/loading/stage_control.hpp"
#include "solver/program/program_file.hpp"
#include "solver/program/standard_tests.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

Specimen specimen() { return one_diagonal_grid(4, 8, 0.04, 0.08); }
const double transit = 0.08 / std::sqrt(25.8e9 / 2650);  // of a bar wave

/// A program that is told what its specimen answers.
class LedPlatens {
public:
    explicit LedPlatens(const LoadingRequest& request, double peak_drop = 0.3)
        : LedPlatens(standard_test(request, peak_drop, specimen(), augig_granite().rock)) {}
    explicit LedPlatens(Program of) : program(std::move(of)), stages(program, specimen(), augig_granite().rock) {}
    void row(double at, double stress = 0, double unbalanced = 1, Feedback feedback = {}, double cracks = 0,
             std::optional<double> strain = std::nullopt) {
        for (auto& column : history.columns) column.push_back(0);
        history[HistoryColumn::time].back() = at;
        history[HistoryColumn::energy_damping].back() = damping;
        history[HistoryColumn::axial_stress].back() = stress;
        history[HistoryColumn::unbalanced_ratio].back() = unbalanced;
        history[HistoryColumn::tensile_cracks].back() = cracks;
        const Rows rows{history, [](const std::string&, std::size_t) { return 0.0; }};
        feedback.time = at;
        feedback.axial_compression = -stress;
        feedback.unbalanced_ratio = unbalanced;
        history[HistoryColumn::axial_strain].back() = strain.value_or(stress > 0 ? at : -at);
        history.size() == 1 ? stages.begin(feedback) : stages.check_stage_end(feedback, rows);
        if (places) places();
        stages.start_next(rows);
    }
    [[nodiscard]] double pressure(double time) const { return stages.values(time).front(); }
    [[nodiscard]] bool is_isotropic() const { return stages.records().empty(); }

    Program program;
    StageController stages;
    History history;
    double damping = 1;            ///< energy that it has absorbed, J
    std::function<void()> places;  ///< what happens to the platens before a stage starts
};

const LoadingRequest triaxial{.test = TestKind::triaxial, .confining_pressure = 4e6};
/// A program of stages.
LedPlatens led_by(const std::string& text) { return LedPlatens(parse_program("name = \"led\"\n" + text, "led.toml")); }

// Without damping a fall counts that outlasts a wave: two transits.
TEST(StandardTest, EndsAtAFallThatOutlastsAWaveWithoutDamping) {
    const auto ends_after = [](double damping, double transits) {
        LedPlatens led(LoadingRequest{});
        led.damping = damping;
        led.row(0);
        led.row(transit, -100e6, 1, {}, 5);
        for (double time = 1.25 * transit; time <= (1.25 + transits) * transit; time += 0.25 * transit) {
            if (!led.stages.finished()) led.row(time, -50e6, 1, {}, 5);
        }
        return led.stages.finished();
    };
    EXPECT_TRUE(ends_after(1, 0));
    EXPECT_FALSE(ends_after(0, 1.5));
    EXPECT_TRUE(ends_after(0, 2.5));
}

TEST(StandardTest, StartsSmoothlyAndKeepsItsSpeed) {
    LedPlatens led(LoadingRequest{.platen_speed = 5e-3});
    EXPECT_EQ(led.program.order, std::vector<std::string>{axial_stage});
    const double dt = 0.25 * transit;
    double speed = 0;
    for (int i = 0; i < 80; ++i) {
        led.row(i * dt);
        const IntervalLoading b = led.stages.next(dt);
        EXPECT_EQ(b.velocity_begin[bottom_platen], speed);  // no jump between intervals
        EXPECT_EQ(b.velocity_begin[top_platen], -speed);
        EXPECT_GE(b.velocity_end[bottom_platen], speed);
        EXPECT_EQ(b.velocity_end[top_platen], -b.velocity_end[bottom_platen]);
        speed = b.velocity_end[bottom_platen];
        EXPECT_EQ(led.stages.platens().speed(), speed);
        if ((i + 1) * dt >= 10 * transit) {
            EXPECT_EQ(speed, 5e-3);
        } else {
            EXPECT_LT(speed, 5e-3);
        }
    }
}

TEST(StandardTest, AppliesThePressureBeforeThePlatens) {
    LedPlatens led(triaxial);
    const double dt = transit;
    double time = 0, pressure = 0;
    led.row(0);
    for (int i = 0; i < 10000 && led.is_isotropic(); ++i) {
        static_cast<void>(led.stages.next(dt));
        time += dt;
        EXPECT_GE(led.pressure(time), pressure);
        EXPECT_LE(led.pressure(time), 4e6);
        pressure = led.pressure(time);
        led.row(time, -pressure, 1e-4);  // a specimen that follows at once
    }
    EXPECT_FALSE(led.is_isotropic());
    EXPECT_EQ(led.stages.records()[0].ended_by, "rest");
    EXPECT_EQ(pressure, 4e6);
    EXPECT_GT(time, 10 * transit);
    for (int i = 0; i < 30; ++i) {
        static_cast<void>(led.stages.next(dt));
        time += dt;
        led.row(time, -5e6, 1);
        EXPECT_EQ(led.pressure(time), 4e6);
    }
    EXPECT_EQ(led.stages.platens().speed(), LoadingRequest{}.platen_speed);
}

// At rest is a specimen that bears what it should: a low unbalanced ratio alone is none where the servo has not arrived.
TEST(StandardTest, WaitsForTheServoInItsIsotropicStage) {
    LedPlatens led(triaxial);
    led.row(0);
    const auto go = [&](double from, double to, double stress) {
        for (double time = from; time < to; time += transit) {
            static_cast<void>(led.stages.next(transit));
            led.row(time + transit, stress, 1e-5);
        }
    };
    go(0, 150 * transit, -3.98e6);  // 0.5 % too low
    EXPECT_TRUE(led.is_isotropic());
    go(150 * transit, 180 * transit, -4e6);
    EXPECT_FALSE(led.is_isotropic());
}

TEST(StandardTest, MovesItsPlatensInItsSenseAtTheAutomaticRate) {
    for (const TestKind test : {TestKind::uniaxial, TestKind::tension}) {
        LedPlatens led(LoadingRequest{.test = test, .rate = RateKind::automatic});
        const double sense = test == TestKind::tension ? -1 : 1;
        const double time_step = 1e-7;
        double time = 0, travel = 0;
        for (int i = 0; i < 50; ++i) {
            led.row(time, 0, 0, {.stored_energy = 100});
            const std::int64_t steps = led.stages.interval_steps(time_step);
            EXPECT_GE(steps, 20);
            EXPECT_LE(static_cast<double>(steps) * time_step, 0.5 * transit);
            const double duration = static_cast<double>(steps) * time_step;
            const IntervalLoading b = led.stages.next(duration);
            EXPECT_GT(sense * b.velocity_end[bottom_platen], 0);
            EXPECT_EQ(b.velocity_end[top_platen], -b.velocity_end[bottom_platen]);
            travel += 0.5 * (b.velocity_begin[bottom_platen] + b.velocity_end[bottom_platen]) * duration;
            time += duration;
        }
        expect_close(led.stages.platens().mean_speed(time), sense * travel / time, 1e-12, std::abs(travel / time));
    }
}

TEST(StandardTest, RestsBetweenBlocks) {
    LedPlatens led(LoadingRequest{.rate = RateKind::blocks, .block_steps = 100});
    EXPECT_EQ(std::get<LoadingBlocks>(*led.program.stages.back().platens).rest, default_rest_tolerance);
    led.row(0);
    EXPECT_EQ(led.stages.interval_steps(1e-7), 20);
    double time = 0;
    const auto next = [&](double unbalanced) {
        led.row(time += 2e-6, 0, unbalanced);
        return led.stages.next(2e-6);
    };
    for (int block = 0; block < 3; ++block) {
        double travel = 0;
        for (int part = 0; part < 5; ++part) {
            const IntervalLoading b = next(part == 0 ? 1e-5 : 1.0);
            travel += 0.5 * (b.velocity_begin[bottom_platen] + b.velocity_end[bottom_platen]) * 2e-6;
        }
        expect_close(travel, 4 * 2e-6 * LoadingRequest{}.platen_speed, 1e-12, travel);  // one part of five is start and stop
        EXPECT_EQ(next(1.0).velocity_end[bottom_platen], 0);
    }
}

// Speeding up over ten transits, and the whole travel at the slowest speed.
TEST(StandardTest, TakesLongestAtItsSlowestSpeed) {
    const auto longest = [](const LoadingRequest& request) { return LedPlatens(request).stages.longest().time; };
    LoadingRequest request{.max_strain = 0.01};
    const double travel = 0.5 * 0.01 * 0.08;
    expect_close(longest(request), 10 * transit + travel / 5e-3, 1e-12, 1);
    request.rate = RateKind::blocks;
    expect_close(longest(request), travel / (0.8 * 5e-3), 1e-12, 1);
    request.rate = RateKind::automatic;
    request.rate_tolerance = 1e-3;
    const double slow = longest(request);
    request.rate_tolerance = 2e-3;
    expect_close(slow, 2 * longest(request), 1e-3, slow);
}

TEST(StandardTest, GivesUpOnASpecimenThatDoesNotComeToRest) {
    Refusals refused;
    refused.add<NumericalError>("in blocks", [] {
        LedPlatens led(LoadingRequest{.rate = RateKind::blocks});
        led.row(0);
        for (int i = 0; i < 1000; ++i) static_cast<void>(led.stages.next(transit));
    });
    refused.add<NumericalError>("under pressure", [] {
        LedPlatens led(triaxial);
        led.row(0);
        for (int i = 1; i < 100000; ++i) {
            static_cast<void>(led.stages.next(transit));
            led.row(i * transit, -1e6, 1);
        }
    });
    expect_golden(refused.text());
}

TEST(StandardTest, EndsBehindThePeakOfACrackedSpecimenUnlessItHasNoDrop) {
    for (const double peak_drop : {0.3, 0.0}) {
        LedPlatens led(LoadingRequest{}, peak_drop);
        led.row(0);
        led.row(1e-5, -10e6);
        led.row(2e-5, -1e6);  // nothing has failed: what swings is no peak
        led.row(3e-5, -100e6, 1, {}, 1);
        led.row(4e-5, -71e6, 1, {}, 1);
        EXPECT_FALSE(led.stages.finished());
        led.row(5e-5, -69e6, 1, {}, 1);
        EXPECT_EQ(led.stages.finished(), peak_drop > 0);
        EXPECT_TRUE(peak_drop == 0 || led.stages.records().back().ended_by == "peak_drop");
    }
}

TEST(StandardTest, HasThePlatensAndTheMembraneOfItsKind) {
    const Specimen s = specimen();
    const Assemblage a = make_assemblage(s, augig_granite().rock, PlaneCondition::strain);
    const ContactParameters contact = augig_contact();
    const Boundary uniaxial = boundary_of_test(a, s, {.platen_friction = 5 * degree}, contact);
    EXPECT_TRUE(uniaxial.prescribed.empty());
    EXPECT_EQ(uniaxial.platens[top_platen].position, 0.04);
    EXPECT_EQ(uniaxial.platens[bottom_platen].side, -1);
    EXPECT_EQ(uniaxial.platens[top_platen].normal_stiffness, contact.normal_stiffness);
    expect_close(uniaxial.platens[top_platen].tan_friction, 0.0874887, 1e-6, 1);  // tan 5°
    EXPECT_FALSE(uniaxial.platens[top_platen].bonded);
    const std::vector<LoadedEdge> edges =
        boundary_of_test(a, s, {.confining_pressure = 4e6, .platen_friction = 5 * degree}, contact).prescribed.edges;
    ASSERT_EQ(edges.size(), 16U);
    for (const LoadedEdge& edge : edges) {
        expect_close(std::abs(a.position[edge.nodes[0]].x), 0.02, 1e-12, 0.02);
        EXPECT_GT((a.position[edge.nodes[1]].y - a.position[edge.nodes[0]].y) * a.position[edge.nodes[0]].x,
                  0);  // solid on the left
        EXPECT_TRUE(edge.is_lateral);
    }
    const Platen tension = boundary_of_test(a, s, {.test = TestKind::tension}, contact).platens[top_platen];
    EXPECT_TRUE(tension.bonded);
    EXPECT_EQ(tension.shear_stiffness, 0);
    EXPECT_EQ(name_of(TestKind::brazilian), "brazilian");
}

TEST(StageController, EndsStagesAtWhatIsReachedFirst) {
    LedPlatens led = led_by(R"(
stages = ["load", "unload", "hold", "load"]
platens = {}
stage.load = { platen_speed = { to = "4 mm/s", over = "2 ms" }, until = { time = "10 ms", axial_stress = "-2 MPa" } }
stage.unload = { platen_speed = "-2 mm/s", until = { time = "10 ms", axial_stress = "-1 MPa" } }
stage.hold = { platen_speed = 0.0, until = { time = "20 ms", rest = 1e-3, peak_drop = 0.5 } }
)");
    IntervalLoading last;
    const auto row = [&](double at, double stress, double unbalanced = 1) {
        led.row(at, stress, unbalanced);
        if (!led.stages.finished()) last = led.stages.next(1e-3);
    };
    row(0, 0);
    expect_close(led.stages.platens().speed(), 2e-3, 1e-12, 1e-3);  // half of the ramp after 1 ms
    row(1e-3, -1e6);
    expect_close(last.velocity_begin[bottom_platen], 2e-3, 1e-12, 1e-3);
    expect_close(last.velocity_begin[top_platen], -2e-3, 1e-12, 1e-3);
    EXPECT_TRUE(led.stages.records().empty());
    row(2e-3, -2.1e6);
    ASSERT_EQ(led.stages.records().size(), 1U);
    EXPECT_EQ(led.stages.records()[0].ended_by, "axial_stress");
    EXPECT_EQ(led.stages.platens().speed(), -2e-3);
    row(3e-3, -2.5e6);  // not reached from this side yet
    EXPECT_EQ(led.stages.records().size(), 1U);
    row(4e-3, -0.9e6);
    ASSERT_EQ(led.stages.records().size(), 2U);
    row(5e-3, -0.8e6, 1e-4);
    row(6e-3, -0.8e6, 1e-2);  // once is by chance
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(led.stages.records().size(), 2U);
        row(7e-3 + 1e-3 * i, -0.8e6, 1e-4);
    }
    ASSERT_EQ(led.stages.records().size(), 3U);
    EXPECT_EQ(led.stages.records()[2].ended_by, "rest");
    EXPECT_EQ(led.stages.records()[2].end, 11e-3);
    row(21e-3, -0.8e6);
    ASSERT_TRUE(led.stages.finished());
    EXPECT_EQ(led.stages.records()[3].ended_by, "time");
}

TEST(StageController, StartsAStageFromTheValuesThereAre) {
    LedPlatens led = led_by(R"(
stages = ["up", "wave", "keep"]
boundary.a = { on = "top", pressure = "1 MPa" }
boundary.b = { on = "bottom" }
stage.up = { a.pressure = { to = "3 MPa", over = "1 ms" }, until.time = "1 ms" }
stage.wave = { a.pressure = { pulse = "1 MPa", over = "1 ms" }, b.velocity_y = 1.0, until.time = "2 ms" }
stage.keep = { b.velocity_y = "free", until.time = "1 ms" }
)");
    EXPECT_TRUE(std::isnan(led.stages.values(0)[1]));  // free until it is named
    led.row(0, 0);
    EXPECT_EQ(led.stages.values(0)[0], 1e6);
    EXPECT_EQ(led.stages.values(0.5e-3)[0], 2e6);
    led.row(1e-3, 0);
    expect_close(led.stages.values(1.5e-3)[0], 4e6, 1e-12, 1e6);
    EXPECT_EQ(led.stages.values(1.5e-3)[1], 1);
    led.row(3e-3, 0);
    EXPECT_EQ(led.stages.values(3.5e-3)[0], 3e6);
    EXPECT_TRUE(std::isnan(led.stages.values(3.5e-3)[1]));
}

const LoadingRequest heated{.rate = RateKind::automatic, .heat = 300};
/// A compression test after heating by 300 K, whose specimen is at rest in each row. \return rows of heating
int heat_through(LedPlatens& led, double near_failure, double stored_energy = 0) {
    const Feedback feedback{.stored_energy = stored_energy, .near_failure = near_failure};
    int rows = 0;
    for (double time = 0; led.stages.records().empty(); time += 0.5 * transit) {
        led.row(time, 0, 1e-4, feedback, 7);
        if (led.stages.is_without_platens()) led.stages.next(0.5 * transit);
        ++rows;
    }
    return rows;
}

TEST(Heating, ReachesItsTemperatureAndRestBeforeThePlatensCome) {
    LedPlatens led(heated);
    led.row(0);
    EXPECT_TRUE(led.stages.is_without_platens());
    EXPECT_EQ(led.stages.interval_steps(transit / 1000), 500);  // half a transit
    EXPECT_EQ(led.stages.next(0.5 * transit).velocity_end[bottom_platen], 0);
    led.history = {};
    const int rows = heat_through(led, 1);
    const double usual = led.stages.longest().usual_heating / (0.5 * transit);
    EXPECT_GT(rows, usual);
    EXPECT_LT(rows, 1.2 * usual);
    EXPECT_FALSE(led.stages.is_without_platens());
    EXPECT_EQ(led.stages.records().back().ended_by, ended_by_rest);
    EXPECT_EQ(led.pressure(led.stages.records().back().end), 300);  // its only amplitude is the temperature
}

// Also of marble, whose crystals are under stress from some tenths of a kelvin on, if all of it is at the slowest rate.
TEST(Heating, HasTheTimeOfTheSlowestRate) {
    const LoadingRequest request{.heat = 480};
    const HeatingControl control(request.heating_tolerance(), {transit, 0.1, 1000});
    double time = 0;
    for (double change = 0; change < request.heat; time += transit) change += transit * control.min_rate(change);
    EXPECT_LT(time, LedPlatens(request).program.stages.front().longest_time);
}

TEST(Heating, LeavesThePlatenSpeedAsItIsByTheEnergyItLocksIn) {
    LedPlatens hot(heated);
    LedPlatens cold(LoadingRequest{.rate = RateKind::automatic});
    cold.row(0, 0, 1e-4);
    constexpr double locked_in = 50;
    heat_through(hot, 0, locked_in);
    const double begin = hot.stages.records().back().end;
    for (int i = 1; i < 200; ++i) {
        Feedback feedback{.kinetic_energy = 1e-5, .stored_energy = 0.1 * i};
        const double speed = cold.stages.next(0.25 * transit).velocity_end[bottom_platen];
        cold.row(0.25 * i * transit, -10e6, 1e-4, feedback);
        feedback.stored_energy += locked_in;
        expect_close(hot.stages.next(0.25 * transit).velocity_end[bottom_platen], speed, 1e-9, speed);
        hot.row(begin + 0.25 * i * transit, -10e6, 1e-4, feedback, 7);
    }
}

// Platens are placed, and strains restart, between the row that ends a stage and the stage that has them.
TEST(StageController, CountsStrainsOfAStageFromItsPlatens) {
    LedPlatens led = led_by(R"(
stages = ["wait", "press"]
platens = {}
stage.wait.until.time = "1 s"
stage.press = { platen_speed = "1 mm/s", until.axial_strain = "-0.1 %" }
)");
    led.row(0, 0, 1, {}, 0, 0.0);
    led.places = [&] { led.history[HistoryColumn::axial_strain].back() = 0; };
    led.row(1, 0, 1, {}, 0, -5e-3);
    led.places = nullptr;
    EXPECT_EQ(led.stages.records().size(), 1U);
    led.row(2, 0, 1, {}, 0, -0.5e-3);
    EXPECT_EQ(led.stages.records().size(), 1U);
    led.row(3, 0, 1, {}, 0, -1.5e-3);
    EXPECT_EQ(led.stages.records().size(), 2U);
}

// A stage that begins while the specimen is unloaded ends by no fall of that, and by one of its own.
TEST(StageController, CountsADropUnderLoadingAlone) {
    LedPlatens led = led_by(R"(
stages = ["load", "fail"]
platens = {}
stage.load = { platen_speed = "1 mm/s", until.axial_stress = "-60 MPa" }
stage.fail = { platen_speed = "1 mm/s", until.peak_drop = 0.3 }
)");
    const auto row = [&](double time, double strain, double stress) {
        led.row(time, -stress, 1e-4, {}, 5, -strain);
        return led.stages.records().size();
    };
    row(0, 0, 0);
    EXPECT_EQ(row(1, 1e-3, 60e6), 1U);
    EXPECT_EQ(row(2, 0.8e-3, 30e6), 1U);  // the platens still retreat
    EXPECT_EQ(row(3, 0.5e-3, 5e6), 1U);
    EXPECT_EQ(row(4, 0.9e-3, 55e6), 1U);
    EXPECT_EQ(row(5, 1.2e-3, 70e6), 1U);
    EXPECT_EQ(row(6, 1.3e-3, 55e6), 1U);
    EXPECT_EQ(row(7, 1.4e-3, 45e6), 2U);
}

// A long stage beside a short one does not part its rows, and a stage that goes far beyond the value that ends it is reported.
TEST(StageController, SpacesRowsByTheStageThatIsOn) {
    const auto overshoots_at = [](double stress) {
        LedPlatens led = led_by(R"(
stages = ["short", "long"]
platens = {}
stage.short = { platen_speed = "1 mm/s", until = { time = "8 ms", axial_stress = "-30 MPa" } }
stage.long = { platen_speed = 0.0, until.time = "8 s" }
)");
        constexpr double time_step = 1e-8;
        led.row(0);
        EXPECT_EQ(led.stages.interval_steps(time_step), std::llround(0.5 * transit / time_step));
        led.row(1e-3, -stress);
        EXPECT_EQ(led.stages.records().size(), 1U);
        EXPECT_EQ(led.stages.interval_steps(time_step), 100000);  // 8 s in 8,000 rows
        return led.stages.overshoots();
    };
    EXPECT_TRUE(overshoots_at(30.5e6).empty());
    ASSERT_EQ(overshoots_at(31e6).size(), 1U);
    expect_golden(overshoots_at(31e6).front());
}

// Forces out of balance of platens that bear nothing yet are those of waves: they do not slow them down.
TEST(Heating, DoesNotSlowPlatensThatBearNothingYet) {
    LedPlatens calm(heated);
    LedPlatens ringing(heated);
    heat_through(calm, 0);
    heat_through(ringing, 0);
    const double begin = calm.stages.records().back().end;
    double speed = 0;
    for (int i = 1; i < 200; ++i) {
        speed = calm.stages.next(0.25 * transit).velocity_end[bottom_platen];
        expect_close(ringing.stages.next(0.25 * transit).velocity_end[bottom_platen], speed, 1e-12, speed);
        calm.row(begin + 0.25 * i * transit, 0, 1e-4);
        ringing.row(begin + 0.25 * i * transit, 0, 0.3);
    }
    for (int i = 200; i < 216; ++i) {
        ringing.row(begin + 0.25 * i * transit, -10e6, 0.3);
        ringing.stages.next(0.25 * transit);
    }
    EXPECT_LT(ringing.stages.next(0.25 * transit).velocity_end[bottom_platen], 0.99 * speed);
}

/// Speed of platens after heating and a hundred transits of loading. \param answer stress and measures after so many transits
double speed_after_heating(const std::function<std::pair<double, Feedback>(double transits)>& answer, double peak_drop = 0.3) {
    LedPlatens led(heated, peak_drop);
    heat_through(led, 0);
    const double begin = led.stages.records().back().end;
    double speed = 0;
    for (int i = 1; i < 400; ++i) {
        speed = led.stages.next(0.25 * transit).velocity_end[bottom_platen];
        const auto& [stress, feedback] = answer(0.25 * i);
        led.row(begin + 0.25 * i * transit, -stress, 1e-4, feedback);
    }
    return speed;
}

TEST(Heating, SlowsNoPlatensBehindAPeak) {
    const auto speed_behind = [](double peak, double stress, double peak_drop = 0.3) {
        const Feedback feedback{.damping_load = 1, .near_failure = 1};
        return speed_after_heating([=](double transits) { return std::pair(transits < 2 ? peak : stress, feedback); }, peak_drop);
    };
    EXPECT_GT(speed_behind(100e6, 69e6), 50 * speed_behind(100e6, 71e6));
    EXPECT_EQ(speed_behind(100e6, 71e6, 0.1), speed_behind(100e6, 71e6));  // a heated peak loses three tenths
    EXPECT_EQ(speed_behind(20e6, 10e6), speed_behind(20e6, 15e6));         // no load yet
}

// What settles on a face that heat has cracked falls before it bears a load, and contacts that heat has cracked are none of the
// test. In bending any load is one.
TEST(Heating, LeavesTheEndOfATestToTheFallOfALoad) {
    for (const TestKind test : {TestKind::uniaxial, TestKind::bend}) {
        LedPlatens led(LoadingRequest{.test = test, .rate = RateKind::automatic, .heat = 300, .span = 0.025});
        heat_through(led, 1);
        double time = led.stages.records().back().end;
        const auto goes_on = [&](double stress, double cracks) {
            led.row(time += transit, -stress, 1e-4, {}, cracks);
            return !led.stages.finished();
        };
        if (test == TestKind::uniaxial) {
            EXPECT_TRUE(goes_on(1e6, 8) && goes_on(0.1e6, 8));  // 0.3 times the tensile strength is 2.6 MPa
        }
        EXPECT_TRUE(goes_on(40e6, 7) && goes_on(10e6, 7));
        EXPECT_TRUE(goes_on(40e6, 8));
        // The stress may rise again until the strain is 1.25 times that of the highest, here as the time.
        EXPECT_TRUE(goes_on(10e6, 8));
        time *= heated_strain;
        EXPECT_FALSE(goes_on(10e6, 8));
    }
}

TEST(Heating, FollowsTheTemperatureOfAProgram) {
    LedPlatens led = led_by(R"(
stages = ["a"]
temperature = { to = "90 K", rate = "30 K/s" }
stage.a.until.time = "5 s"
)");
    led.row(0);
    led.stages.next(1);
    EXPECT_EQ(led.pressure(1), 30);
    EXPECT_EQ(led.pressure(4), 90);
}

}  // namespace
}  // namespace graincrack::test
