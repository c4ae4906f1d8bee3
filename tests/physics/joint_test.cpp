// A plane of weakness at the automatic rate: it slides at its static strength, and neither inertia nor damping carries load.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solver/loading/standard_tests.hpp"
#include "solver/run/sensitivity.hpp"
#include "tests/support/check.hpp"
#include "tests/support/jointed_test.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::verify;

TEST(Joint, TwoBlocksSlideAtJaegersStrengthWithDefaultOptions) {
    for (const double angle : {50.0, 62.0}) {
        for (const double pressure : {5.0, 20.0}) {
            const test::JointedTest joint{angle * test::degree, pressure * test::MPa};
            const Specimen specimen = test::jointed_rectangle(6, 6, 0.06, 0.2, joint.angle, test::Blocks::of_one_grain);
            const TestOutcome outcome = run_test(specimen, joint.request(), "joint", Verbosity::quiet);
            const std::string name = fmt::format("two blocks, {} deg, {} MPa", angle, pressure);
            EXPECT_EQ(outcome.header.stop_reason, "strain limit");  // it slid on at its strength
            verify("specimens: strength of a joint, " + name + " (MPa)", outcome.header.peak_axial_stress / test::MPa,
                   joint.strength() / test::MPa, 0.02, "Jaeger; the issue asks for 2 %");
            verify("specimens: load that damping carries on a joint, " + name, outcome.header.damping_load, 0, 0.002,
                   "what the automatic rate allows", 1);
        }
    }
}

TEST(Joint, HalfTheRateIsHalfTheSpeed) {
    const test::JointedTest joint{50 * test::degree, 5 * test::MPa};
    const Specimen specimen = test::jointed_rectangle(4, 4, 0.06, 0.2, joint.angle, test::Blocks::of_one_grain);
    const SimulationRequest request = joint.request();
    const auto speed_of = [&specimen](const SimulationRequest& r) {
        return run_test(specimen, r, "joint", Verbosity::quiet).header.platen_speed;
    };
    const double whole = speed_of(request);
    // Where the measures hold the speed they follow it to the lag of the control, a few per cent; everywhere else it is halved.
    test::expect_close(speed_of(sensitivity_cases(request, program_of(request, specimen), 0)[0].request), whole / 2, 0.05,
                       whole / 2);
}

}  // namespace
}  // namespace graincrack
