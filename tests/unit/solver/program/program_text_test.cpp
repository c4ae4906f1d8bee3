// Programs as text.
#include "solver/program/program_file.hpp"

#include <gtest/gtest.h>

#include "solver/program/standard_tests.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

// Written as a file and read again, a test is the same program to the last digit.
TEST(ProgramText, ReadAgainItIsTheSameProgram) {
    const Specimen specimen = test::one_diagonal_grid(4, 8, 0.04, 0.08);
    for (const TestKind test : {TestKind::uniaxial, TestKind::triaxial, TestKind::tension}) {
        for (const RateKind rate : {RateKind::fixed, RateKind::automatic, RateKind::blocks}) {
            LoadingRequest request;
            request.test = test;
            request.rate = rate;
            request.platen_speed = 1.0 / 300;
            request.confining_pressure = test == TestKind::triaxial ? 1e7 / 3 : 0;
            const double peak_drop = rate == RateKind::fixed ? 0 : 0.3;
            const Program program = standard_test(request, peak_drop, specimen, test::augig_granite().rock);
            const std::string text = program_text(program);
            const Program again = parse_program(text, "again.toml");
            EXPECT_EQ(program_text(again), text);
            EXPECT_EQ(again.order, program.order);
            EXPECT_EQ(again.platens->bonded, test == TestKind::tension);
        }
    }
}

const std::string everything = R"(name = "a \"b\""
stages = ["s 0", "s 1", "s 2"]
damping = "none"
gravity = [0.0, -9.81]
row_every = 1e-06
temperature = 20.0

[platens]
bonded = true
max_strain = 0.02
direction = 1.25

[platens.bottom]
at = [-0.03, 0.03]
width = 0.002

[platens.top]
on = ["top"]

[boundary.a]
on = ["left", "right"]
box = [-0.001, 0.001, 0.0, 0.004]
angles = [-0.25, 0.25]
velocity_x = "free"

[boundary.d]
at = [0.0, -0.04]
velocity_y = 0.0

[probe.p]
point = [0.001, 0.0]

[probe.c]
circle = [0.0, 0.0, 0.005]

[probe.r]
ring = [0.0, 0.0, 0.005]
points = 12
reach = 0.001

[probe.g]
gauge = [0.0, 0.0, 0.01, 0.0]

[initial.0]
on = ["top"]
velocity = [0.001, 0.0]

[stage."s 0"]
platens = "absent"
temperature = { to = 50.0, rate = 10000.0 }
until = { time = 0.001 }

[stage."s 1"]
a.velocity_x = { sine = 1.0, frequency = 1000.0, phase = 0.5, cycles = 2.0 }
a.pressure = { times = [0.0, 0.001], values = [0.0, 1000000.0] }
platen_pressure = "keep"
temperature = { to = 100.0, rate = "auto", tolerance = 0.003, share = 0.5 }
until = { time = 0.003, rest = 0.001, axial_stress = -2000000.0, c.stress_yy = -1000000.0, g.elongation = 0.0001 }
must_end_by = "rest"

[stage."s 2"]
a.traction_y = { ricker = 1000.0, frequency = 10000.0, at = 0.0002 }
a.pressure = { pulse = 1000000.0, over = 1e-05 }
a.shear = { to = 1000000.0, over = 0.001 }
platen_speed = 0.001
until = { peak_drop = 0.2 }
)";

TEST(ProgramText, OfAProgramWithEveryKeyIsThatOfItsFile) {
    EXPECT_EQ(program_text(parse_program(everything, "everything.toml")), everything);
}

}  // namespace
}  // namespace graincrack
