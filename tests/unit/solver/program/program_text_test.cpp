// Programs as text.
#include "solver/program/program_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "solver/program/standard_tests.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {
namespace {

// Written as a file and read again, a test is the same program to the last digit.
TEST(ProgramText, IsTheSameProgramWhenReadAgain) {
    const Specimen specimen = one_diagonal_grid(4, 8, 0.04, 0.08);
    for (const TestKind test : {TestKind::uniaxial, TestKind::triaxial, TestKind::tension}) {
        for (const RateKind rate : {RateKind::fixed, RateKind::automatic, RateKind::blocks}) {
            const LoadingRequest request{.test = test,
                                         .rate = rate,
                                         .platen_speed = 1.0 / 300,
                                         .confining_pressure = test == TestKind::triaxial ? 1e7 / 3 : 0};
            const double peak_drop = rate == RateKind::fixed ? 0 : 0.3;
            const Program program = standard_test(request, peak_drop, specimen, augig_granite().rock);
            const std::string text = program_text(program);
            const Program again = parse_program(text, "again.toml");
            EXPECT_EQ(program_text(again), text);
            EXPECT_EQ(again.order, program.order);
            EXPECT_EQ(again.platens->bonded, test == TestKind::tension);
        }
    }
}

TEST(ProgramText, IsThatOfTheFileWithEveryKey) {
    const std::string path = GRAINCRACK_SOURCE "/tests/unit/solver/program/every_key.toml";
    std::ifstream file(path);
    EXPECT_EQ(program_text(read_program(path)), std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace
}  // namespace graincrack::test
