// The program's file: all keys, and what is said of wrong ones.
#include "solver/program/program_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "share/base/error.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/rows.hpp"

namespace graincrack::test {
namespace {

const std::string least = R"(
name = "least"
stages = ["run"]
stage.run.until.time = "1 ms"
)";

// program_text_test has every key; here are units, and the order of the file.
TEST(ProgramFile, ReadsUnitsAndKeepsTheOrder) {
    const Program p = parse_program(R"(
name = "some"
row_every = "2 us"
stages = ["a", "b", "a"]
platens.max_strain = "2 %"
[boundary.side]
on = ["left", "right"]
box = ["-1 mm", "1 mm", 0, "4 mm"]
pressure = "3 MPa"
[boundary.roof]
on = "top"
[stage.a]
roof.velocity_x = { sine = "1 m/s", frequency = "1 kHz", cycles = 2 }
until = { time = "3 ms", axial_stress = "-2 MPa", side.force_x = "1 kN" }
[stage.b]
side.traction_y = "1 kPa"
until.time = "1 ms"
)",
                                    "some.toml");
    EXPECT_EQ(p.row_interval, 2e-6);
    EXPECT_EQ(p.platens->max_strain, 0.02);
    ASSERT_EQ(p.boundary_conditions.size(), 2U);
    EXPECT_EQ(p.boundary_conditions[0].name, "side");
    EXPECT_EQ(p.boundary_conditions[0].region.top, 0.004);
    EXPECT_EQ(p.boundary_conditions[0].is_set, (std::array<bool, n_actions>{false, false, false, true, true, false}));
    EXPECT_NEAR(p.longest_time(), 7e-3, 1e-15);
    EXPECT_EQ(p.stage("a").settings.at("roof")[0]->duration, 2e-3);
    ASSERT_EQ(p.stage("a").until.size(), 2U);
    EXPECT_EQ(p.stage("a").until[0].value, -2e6);
    EXPECT_EQ(p.stage("a").until[1].name, "side.force_x");
    expect_golden(p.why_dynamic());
}

TEST(ProgramFile, RefusesWhatIsWrongInOneLine) {
    EXPECT_EQ(parse_program(least, "least.toml").name, "least");
    EXPECT_EQ(parse_program(least, "least.toml").why_dynamic(), "");
    const std::string press =
        "name = \"x\"\nstages = [\"run\"]\nplatens.max_strain = 0.01\n[stage.run]\nuntil.peak_drop = 0.3\nplaten_speed = 1";
    EXPECT_TRUE(std::isinf(parse_program(press, "press.toml").longest_time()));
    const auto read = [](const std::string& text) { parse_program(text, "wrong.toml"); };
    EXPECT_EQ(expect_refused<InputError>("solver/program/program_file.toml", read), 46U);
    Refusals refused;
    refused.add<InputError>("no file", [] { read_program("/nowhere/program.toml"); });
    expect_golden(refused.text());
}

TEST(ProgramFile, ReadsTheShippedPrograms) {
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(GRAINCRACK_SOURCE) + "/share/programs")) {
        const Program p = read_program(entry.path().string());
        EXPECT_TRUE(p.damping.has_value()) << entry.path();
        EXPECT_GT(p.longest_time(), 0.0);
        ++read;
    }
    EXPECT_EQ(read, 4);
}

}  // namespace
}  // namespace graincrack::test
