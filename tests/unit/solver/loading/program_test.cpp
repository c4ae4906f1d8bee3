// The program's file, its functions of time, and its stages.
#include "solver/setup/program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "share/base/error.hpp"
#include "solver/loading/program_file.hpp"
#include "solver/loading/stage_control.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

using test::expect_close;
using test::expect_one_line;

const std::string least = R"(
name = "least"
stages = ["run"]
stage.run.until.time = "1 ms"
)";

void refuse(const std::string& text, const std::vector<std::string>& parts, int line = __builtin_LINE()) {
    std::vector<std::string> all = parts;
    all.push_back("wrong.toml");
    expect_one_line<InputError>([&] { parse_program(text, "wrong.toml"); }, all, __builtin_FILE(), line);
}

TEST(ProgramFile, ReadsEverything) {
    const Program p = parse_program(R"(
name = "all"
damping = "none"
gravity = ["1 m/s2", -9.81]
row_every = "2 us"
stages = ["a", "b", "a"]
[platens]
glued = true
max_strain = "2 %"
[boundary.side]
on = ["left", "right"]
box = ["-1 mm", "1 mm", 0, "4 mm"]
pressure = "3 MPa"
[boundary.roof]
on = "top"
velocity_x = "free"
[probe.p]
point = ["1 mm", 0]
[probe.c]
circle = [0, 0, "5 mm"]
[initial.all]
on = "top"
velocity = ["1 mm/s", 0]
[stage.a]
platen_speed = { to = "5 mm/s", over = "1 ms" }
side.pressure = { times = [0, "1 ms"], values = [0, "1 MPa"] }
roof = { velocity_x = { sine = "1 m/s", frequency = "1 kHz", cycles = 2, phase = "90 deg" }, velocity_y = 0.5 }
until = { time = "3 ms", rest = 1e-3, axial_stress = "-2 MPa", c.stress_yy = "-1 MPa", side.force_x = "1 kN" }
[stage.b]
platen_pressure = "1 MPa"
side.traction_y = { ricker = "1 kPa", frequency = "10 kHz" }
side.pressure = { pulse = "1 MPa", over = "10 us" }
until = { time = "1 ms", peak_drop = 0.2 }
)",
                                    "all.toml");
    EXPECT_EQ(p.name, "all");
    EXPECT_EQ(p.damping, 0.0);
    EXPECT_EQ(p.gravity.y, -9.81);
    EXPECT_EQ(p.row_interval, 2e-6);
    EXPECT_TRUE(p.platens->bonded);
    EXPECT_EQ(p.platens->max_strain, 0.02);
    ASSERT_EQ(p.boundary_conditions.size(), 2U);
    EXPECT_EQ(p.boundary_conditions[0].name, "side");  // in the order of the file
    EXPECT_EQ(p.boundary_conditions[0].region.parts, (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(p.boundary_conditions[0].region.top, 0.004);
    EXPECT_EQ(p.boundary_conditions[0].is_set, (std::array<bool, n_actions>{false, false, false, true, true}));
    EXPECT_TRUE(std::isnan(p.boundary_conditions[1].start[0]->value));
    ASSERT_EQ(p.probes.size(), 2U);
    EXPECT_TRUE(p.probes[1].is_circle);
    EXPECT_EQ(p.probes[1].radius, 0.005);
    EXPECT_EQ(p.order.size(), 3U);
    EXPECT_NEAR(p.longest_time(), 7e-3, 1e-15);
    const Stage& a = p.stage("a");
    EXPECT_EQ(std::get<TimeFunction>(*a.platens).kind, TimeFunction::Kind::ramp);
    EXPECT_EQ(std::get<PressureServo>(*p.stage("b").platens).pressure.value, 1e6);
    EXPECT_EQ(a.settings.at("roof")[0]->duration, 2e-3);
    EXPECT_EQ(a.settings.at("roof")[1]->value, 0.5);
    ASSERT_EQ(a.until.size(), 3U);
    EXPECT_EQ(a.until[0].name, "axial_stress");
    EXPECT_EQ(a.until[0].value, -2e6);
    EXPECT_EQ(a.until[1].name, "c.stress_yy");
    EXPECT_EQ(a.until[2].name, "side.force_x");
    EXPECT_NE(p.why_dynamic(), "");
}

TEST(ProgramFile, WhatIsWrongIsOneLine) {
    EXPECT_EQ(parse_program(least, "least.toml").name, "least");
    EXPECT_EQ(parse_program(least, "least.toml").why_dynamic(), "");
    refuse("stages = [\"run\"]\nstage.run.until.time = 1", {"name", "missing"});
    refuse("name = \"x\"\nstage.run.until.time = 1", {"stages", "missing"});
    refuse("name = \"x\"\nstages = [\"run\", \"rest\"]\nstage.run.until.time = 1", {"line 2", "[stage.rest]"});
    refuse(least + "[stage.other]\nuntil.time = 1", {"line 5", "stage.other", "in no place"});
    refuse(least + "gravty = [0, 0]", {"gravty", "did you mean gravity"});
    refuse(least + "gravity = [0, \"9 m/s\"]", {"gravity", "speed", "acceleration"});
    refuse(least + "gravity = [0]", {"gravity", "two"});
    refuse(least + "stage.run.until.axial_stres = 1", {"axial_stres", "did you mean axial_stress"});
    refuse(least + "stage.run.until.nobody.force_x = 1", {"nobody", "no probe"});
    refuse(least + "stage.run.platen_speed = 1", {"[platens]"});
    refuse("name = \"x\"\nstages = [\"run\"]\nstage.run.platen_speed = 1", {"platens"});
    refuse("name = \"x\"\nstages = [\"run\"]\n[stage.run]\nuntil.rest = 0.1",
           {"stage.run.until.time", "missing", "longest time"});
    refuse("name = \"x\"\nstages = [\"run\"]\n[stage.run]", {"stage.run.until", "missing"});
    const std::string press = "name = \"x\"\nstages = [\"run\"]\nplatens.max_strain = 0.01\n[stage.run]\nuntil.peak_drop = 0.3\n";
    refuse(press + "platen_speed = { auto = \"up\" }", {"platen_speed.auto", "together"});
    refuse(press + "platen_speed = { auto = \"apart\", tolerence = 1 }", {"tolerence", "did you mean tolerance"});
    refuse(press + "platen_speed = { blocks = 0.01, steps = 12.5 }", {"platen_speed", "whole number"});
    refuse(press + "platen_speed = { to = 0, over = 1 }", {"stage.run.until.time", "longest time"});
    refuse(press + "platen_speed = 1\nmust_end_by = \"rest\"", {"must_end_by", "none of the ends"});
    EXPECT_TRUE(std::isinf(parse_program(press + "platen_speed = 1", "press.toml").longest_time()));
    refuse(least + "[boundary.a]\nvelocity_x = 1", {"boundary.a", "nowhere"});
    refuse(least + "[boundary.a]\non = \"top\"", {"boundary.a", "does nothing"});
    refuse(least + "[boundary.a]\non = \"top\"\nvelocity_x = \"1 MPa\"", {"line 7", "boundary.a.velocity_x", "stress", "speed"});
    refuse(least + "[boundary.a]\non = \"top\"\npressure = \"free\"", {"boundary.a.pressure", "free"});
    refuse(least + "[boundary.a]\non = \"top\"\npressure = { to = 1 }", {"pressure.over", "missing"});
    refuse(least + "[boundary.a]\non = \"top\"\npressure = { too = 1 }", {"boundary.a.pressure", "no function of time"});
    refuse(least + "[boundary.a]\non = \"top\"\npressure = { to = 1, over = 1, sine = 2 }", {"sine", "unknown key"});
    refuse(least + "[boundary.a]\non = \"top\"\npressure = { times = [0, 0], values = [1, 2] }", {"times", "ascend"});
    refuse(least + "[boundary.a]\non = \"top\"\npressure = { times = [0, 1], values = [1] }", {"values", "as many"});
    refuse(least + "[boundary.a]\nbox = [1, 0, 0, 1]\nvelocity_x = 1", {"box", "left <= right"});
    refuse(least + "[probe.a]\npoint = [0, 0]\ncircle = [0, 0, 1]", {"probe.a", "either"});
    refuse(least + "[probe.a]\ncircle = [0, 0, 0]", {"probe.a.circle", "radius"});
    refuse(least + "[boundary.a]\non = \"top\"\npressure = 1\n[probe.a]\npoint = [0, 0]", {"probe.a", "another name"});
    refuse(least + "[initial.a]\non = \"top\"", {"initial.a.velocity", "missing"});
    refuse(least + "damping = 2", {"damping", "out of bounds"});
    refuse(least + "row_every = [1]", {"row_every", "no quantity"});
    refuse("name = ", {"not TOML"});
    expect_one_line<InputError>([] { read_program("/nowhere/program.toml"); }, {"/nowhere/program.toml", "cannot be read"});
}

TEST(ProgramFile, TheShippedProgramsAreRead) {
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(GRAINCRACK_SOURCE) + "/share/programs")) {
        const Program p = read_program(entry.path().string());
        EXPECT_TRUE(p.damping.has_value()) << entry.path();
        EXPECT_GT(p.longest_time(), 0.0);
        ++read;
    }
    EXPECT_EQ(read, 4);
}

TEST(TimeFunction, TakesItsValues) {
    TimeFunction f;
    f.kind = TimeFunction::Kind::ramp;
    f.from = 1;
    f.value = 3;
    f.duration = 2;
    EXPECT_EQ(f(-1), 1);
    EXPECT_EQ(f(0.5), 1 + 2 * (0.0625 * 2.5));
    EXPECT_EQ(f(1), 2);
    EXPECT_EQ(f(5), 3);
    EXPECT_EQ(f.end(), 2);
    f.kind = TimeFunction::Kind::pulse;
    expect_close(f(1), 4, 1e-15, 1);
    expect_close(f(0.5), 2.5, 1e-15, 1);
    EXPECT_EQ(f(2.1), 1);
    f.kind = TimeFunction::Kind::sine;
    f.frequency = 0.25;
    f.phase = std::numbers::pi / 6;
    expect_close(f(0), 2.5, 1e-15, 1);
    expect_close(f(1), 1 + 3 * std::cos(f.phase), 1e-15, 1);
    EXPECT_EQ(f(2.1), 1);  // half a cycle
    f.duration = 0;
    EXPECT_NE(f(2.1), 1);
    EXPECT_TRUE(std::isinf(f.end()));
    f.kind = TimeFunction::Kind::ricker;
    f.peak_time = 6;
    EXPECT_EQ(f(6), 4);
    // Its zeros are 1/(√2 π f) from the peak, its mean over time is 0.
    expect_close(f(6 + 1 / (std::sqrt(2.0) * std::numbers::pi * f.frequency)), 1, 1e-14, 1);
    double sum = 0;
    for (int i = -3000; i <= 3000; ++i) sum += f(6 + 0.01 * i) - 1;
    expect_close(0.01 * sum, 0, 1e-9, 1);
    EXPECT_LT(std::abs(f(f.end()) - 1), 1e-12);
    f.kind = TimeFunction::Kind::table;
    f.times = {1, 2, 4};
    f.values = {10, 20, 0};
    EXPECT_EQ(f(0), 10);
    EXPECT_EQ(f(1.5), 15);
    EXPECT_EQ(f(3), 10);
    EXPECT_EQ(f(4), 0);
    EXPECT_EQ(f(9), 0);
    EXPECT_EQ(f.end(), 4);
}

/// A stage controller that is told time and axial stress.
struct Led {
    Program program;
    StageController stage_controller;
    History history;
    double time = 0;
    explicit Led(const std::string& text)
        : program(parse_program(text, "led.toml")),
          stage_controller(program, test::one_diagonal_grid(2, 2, 0.02, 0.02), test::augig_granite().rock) {}
    void row(double at, double stress, double unbalanced = 1, double cracks = 0) {
        time = at;
        for (auto& column : history.columns) column.push_back(0);
        history[HistoryColumn::time].back() = at;
        history[HistoryColumn::energy_damping].back() = 1;
        history[HistoryColumn::axial_stress].back() = stress;
        history[HistoryColumn::unbalanced_ratio].back() = unbalanced;
        history[HistoryColumn::shear_cracks].back() = cracks;
        const std::function<double(const std::string&, std::size_t)> none = [](const std::string&, std::size_t) { return 0.0; };
        const StageFeedback feedback{at, history, none};
        history.size() == 1 ? stage_controller.begin(feedback) : stage_controller.check_stage_end(feedback);
        if (!stage_controller.finished()) last = stage_controller.next(1e-3);
    }
    IntervalLoading last;
};

TEST(StageController, EndsStagesAtWhatIsReachedFirst) {
    Led led(R"(
name = "led"
stages = ["load", "unload", "hold", "load"]
platens.bonded = false
[stage.load]
platen_speed = { to = "4 mm/s", over = "2 ms" }
until = { time = "10 ms", axial_stress = "-2 MPa" }
[stage.unload]
platen_speed = "-2 mm/s"
until = { time = "10 ms", axial_stress = "-1 MPa" }
[stage.hold]
platen_speed = 0.0
until = { time = "20 ms", rest = 1e-3, peak_drop = 0.5 }
)");
    led.row(0, 0);
    expect_close(led.stage_controller.platens().speed(), 2e-3, 1e-12, 1e-3);  // half of the ramp after 1 ms
    led.row(1e-3, -1e6);
    expect_close(led.last.velocity_begin[bottom_platen], 2e-3, 1e-12, 1e-3);
    expect_close(led.last.velocity_begin[top_platen], -2e-3, 1e-12, 1e-3);
    EXPECT_TRUE(led.stage_controller.records().empty());
    led.row(2e-3, -2.1e6);
    ASSERT_EQ(led.stage_controller.records().size(), 1U);
    EXPECT_EQ(led.stage_controller.records()[0].ended_by, "axial_stress");
    EXPECT_EQ(led.stage_controller.platens().speed(), -2e-3);
    led.row(3e-3, -2.5e6);  // not reached from this side yet
    EXPECT_EQ(led.stage_controller.records().size(), 1U);
    led.row(4e-3, -0.9e6);
    ASSERT_EQ(led.stage_controller.records().size(), 2U);
    led.row(5e-3, -0.8e6, 1e-4);
    led.row(6e-3, -0.8e6, 1e-2);  // once is by chance
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(led.stage_controller.records().size(), 2U);
        led.row(7e-3 + 1e-3 * i, -0.8e6, 1e-4);
    }
    ASSERT_EQ(led.stage_controller.records().size(), 3U);
    EXPECT_EQ(led.stage_controller.records()[2].ended_by, "rest");
    EXPECT_EQ(led.stage_controller.records()[2].end, 11e-3);
    led.row(21e-3, -0.8e6);
    ASSERT_TRUE(led.stage_controller.finished());
    EXPECT_EQ(led.stage_controller.records()[3].ended_by, "time");
}

TEST(StageController, AStageGoesOnFromWhatIsThere) {
    Led led(R"(
name = "led"
stages = ["up", "wave", "keep"]
boundary.a = { on = "top", pressure = "1 MPa" }
boundary.b = { on = "bottom" }
stage.up = { a.pressure = { to = "3 MPa", over = "1 ms" }, until.time = "1 ms" }
stage.wave = { a.pressure = { pulse = "1 MPa", over = "1 ms" }, b.velocity_y = 1.0, until.time = "2 ms" }
stage.keep = { b.velocity_y = "free", until.time = "1 ms" }
)");
    EXPECT_TRUE(std::isnan(led.stage_controller.values(0)[1]));  // free until it is named
    led.row(0, 0);
    EXPECT_EQ(led.stage_controller.values(0)[0], 1e6);
    EXPECT_EQ(led.stage_controller.values(0.5e-3)[0], 2e6);
    led.row(1e-3, 0);
    expect_close(led.stage_controller.values(1.5e-3)[0], 4e6, 1e-12, 1e6);
    EXPECT_EQ(led.stage_controller.values(1.5e-3)[1], 1);
    led.row(3e-3, 0);
    EXPECT_EQ(led.stage_controller.values(3.5e-3)[0], 3e6);
    EXPECT_TRUE(std::isnan(led.stage_controller.values(3.5e-3)[1]));
}

}  // namespace
}  // namespace graincrack
