// The program's file: all keys, and what is said of wrong ones.
#include "solver/program/program_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"

namespace graincrack {
namespace {

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
    EXPECT_EQ(p.boundary_conditions[0].is_set, (std::array<bool, n_actions>{false, false, false, true, true}));
    EXPECT_NEAR(p.longest_time(), 7e-3, 1e-15);
    EXPECT_EQ(p.stage("a").settings.at("roof")[0]->duration, 2e-3);
    ASSERT_EQ(p.stage("a").until.size(), 2U);
    EXPECT_EQ(p.stage("a").until[0].value, -2e6);
    EXPECT_EQ(p.stage("a").until[1].name, "side.force_x");
    EXPECT_EQ(p.why_dynamic(), "boundary.roof drives nodes");
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
    refuse(least + "stage.run.temperature = \"600 K\"", {"stage.run.temperature", "at 573 deg C quartz changes", "480 K"});
    refuse(least + "stage.run.temperature = { rate = \"auto\" }", {"stage.run.temperature.to", "missing"});
    refuse(least + "stage.run.temperature = { to = 9, rate = \"9 K\" }", {"stage.run.temperature.rate", "units that fit: K/s"});
    refuse("temperature = 500\n" + least, {"temperature", "480 K"});
    refuse(least + "stage.run.platens = \"absent\"", {"stage.run.platens", "the program has none"});
    refuse(
        "name = \"a\"\nstages = [\"b\", \"c\"]\nplatens.max_strain = 0.1\nstage.b.until.time = 1\nstage.c.until.time = 1\n"
        "stage.c.platens = \"absent\"",
        {"stage.c", "platens", "already in stage.b"});
    refuse(least + "stage.run.temperature = \"20 m\"", {"stage.run.temperature", "length", "units that fit: K"});
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

}  // namespace
}  // namespace graincrack
