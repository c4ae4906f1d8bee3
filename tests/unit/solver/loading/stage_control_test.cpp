// Stages of a program, told what its specimen answers.
#include "solver/loading/stage_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/program/program_file.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

using test::expect_close;

/// A stage controller that is told time and axial stress.
struct LedStages {
    Program program;
    StageController stage_controller;
    History history;
    double time = 0;
    explicit LedStages(const std::string& text)
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
        const Rows rows{history, [](const std::string&, std::size_t) { return 0.0; }};
        Feedback feedback;
        feedback.time = at;
        feedback.axial_compression = -stress;
        feedback.unbalanced_ratio = unbalanced;
        history.size() == 1 ? stage_controller.begin(feedback, rows) : stage_controller.check_stage_end(feedback, rows);
        if (!stage_controller.finished()) last = stage_controller.next(1e-3);
    }
    IntervalLoading last;
};

TEST(StageController, EndsStagesAtWhatIsReachedFirst) {
    LedStages led(R"(
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
    LedStages led(R"(
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
