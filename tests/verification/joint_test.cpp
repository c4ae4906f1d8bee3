// A plane of weakness in 1,024 grains, with the automatic loading rate.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/jointed_test.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

void expect_jaeger(double angle, double pressure, bool mass_scaling = false, double cohesion = 0) {
    const test::JointedTest joint{angle * test::degree, pressure * test::MPa, 30 * test::degree, cohesion * test::MPa};
    const Specimen specimen = joint.specimen(16, 16, test::Blocks::of_grains);
    EXPECT_EQ(specimen.n_grains(), 1024U);
    SimulationRequest request = joint.request();
    request.mass_scaling = mass_scaling;
    if (cohesion > 0) request.law = LawVariant::cohesive_frictional;
    const TestOutcome outcome = run_test(specimen, request, "joint", Verbosity::quiet);
    const std::string name = fmt::format("1,024 grains, {} deg, {} MPa{}{}", angle, pressure,
                                         mass_scaling ? ", mass scaling" : "", cohesion > 0 ? ", where two phases meet" : "");
    EXPECT_EQ(outcome.header.stop_reason, "strain limit");
    test::verify("specimens: strength of a joint, " + name + " (MPa)", outcome.header.peak_axial_stress / test::MPa,
                 joint.strength() / test::MPa, 0.01, "Jaeger, to 1 %");
}

TEST(JointInGrains, At50DegreesUnder5MPa) { expect_jaeger(50, 5); }
TEST(JointInGrains, At50DegreesUnder20MPa) { expect_jaeger(50, 20); }
TEST(JointInGrains, At62DegreesUnder5MPa) { expect_jaeger(62, 5); }
TEST(JointInGrains, At62DegreesUnder20MPa) { expect_jaeger(62, 20); }
TEST(JointInGrains, At50DegreesUnder20MPaWithMassScaling) { expect_jaeger(50, 20, true); }
TEST(JointInGrains, At62DegreesUnder5MPaWithMassScaling) { expect_jaeger(62, 5, true); }
TEST(JointInGrains, WherePhasesMeetAt60DegreesUnder20MPa) { expect_jaeger(60, 20, true, 10); }

}  // namespace
}  // namespace graincrack
