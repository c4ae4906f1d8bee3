// A plane of weakness at the automatic rate: it slides at its static strength, and neither inertia nor damping carries load.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "solver/run/sensitivity.hpp"
#include "solver/setup/setup.hpp"
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
            const Specimen specimen = joint.specimen(6, 6, test::Blocks::of_one_grain);
            const TestOutcome outcome = run_test(specimen, joint.request(), "joint", Verbosity::quiet);
            const std::string name = fmt::format("two blocks, {} deg, {} MPa", angle, pressure);
            EXPECT_EQ(outcome.header.stop_reason, "strain limit");  // it slid on at its strength
            verify("specimens: strength of a joint, " + name + " (MPa)", outcome.header.peak_axial_stress / test::MPa,
                   joint.strength() / test::MPa, 0.01, "Jaeger (1960), to 1 %");
            verify("specimens: load that damping carries on a joint, " + name, outcome.header.damping_load, 0, 0.002,
                   "what the automatic rate allows", 1);
        }
    }
}

test::JointedTest plane_of_a_class(double angle, double pressure) {
    return {angle * test::degree, pressure * test::MPa, 30 * test::degree, 10 * test::MPa};
}
TestOutcome outcome_of(const test::JointedTest& plane, LawVariant law) {
    SimulationRequest request = plane.request();
    request.law = law;
    request.peak_drop = 0;
    return run_test(plane.specimen(4, 4, test::Blocks::of_one_grain), request, "plane", Verbosity::quiet);
}

// The class of two phases is weak and that of each with itself strong: the plane where they meet slides with the values of its
// class. Friction adds to cohesion; coulomb-slip then loses all cohesion at once.
TEST(Joint, APlaneOfAClassSlidesAtJaegersStrengthWithCohesionAndFriction) {
    for (const LawVariant law : {LawVariant::cohesive_frictional, LawVariant::coulomb_slip}) {
        for (const auto& [angle, pressure] : {std::pair{50.0, 5.0}, std::pair{60.0, 20.0}}) {
            const test::JointedTest plane = plane_of_a_class(angle, pressure);
            verify(fmt::format("phases: plane of a class, {}, {} deg, {} MPa (MPa)", name_of(law), angle, pressure),
                   outcome_of(plane, law).header.peak_axial_stress / test::MPa, plane.strength() / test::MPa, 0.01,
                   "Jaeger (1960), to 1 %");
        }
    }
}

// In the law of the paper friction comes after cohesion: the peak is that of cohesion alone, what follows is that of friction.
TEST(Joint, APlaneOfAClassSlidesAtItsCohesionAndThenAtItsFrictionWithTheDefaultLaw) {
    const test::JointedTest plane = plane_of_a_class(60, 5);
    test::JointedTest cohesion = plane;
    cohesion.friction_angle = 0;
    test::JointedTest friction = plane;
    friction.cohesion = 0;
    const TestOutcome outcome = outcome_of(plane, SimulationRequest{}.law);
    verify("phases: plane of a class, consistent, 60 deg, 5 MPa, peak (MPa)", outcome.header.peak_axial_stress / test::MPa,
           cohesion.strength() / test::MPa, 0.02, "Jaeger with cohesion alone");
    verify("phases: plane of a class, consistent, 60 deg, 5 MPa, at the end (MPa)",
           -outcome.history[HistoryColumn::axial_stress].back() / test::MPa, friction.strength() / test::MPa, 0.01,
           "Jaeger with friction alone");
}

// Only the joint can slide: whether its class or the whole rock has its friction, it does so at the same strength, also where
// grains meet others than those that they were bonded to.
TEST(Joint, AFlawSlidesAtTheFrictionOfItsClass) {
    const test::JointedTest joint{50 * test::degree, 5 * test::MPa};
    Specimen specimen = joint.specimen(6, 6, test::Blocks::of_grains);
    SimulationRequest request = joint.request();
    request.mass_scaling = true;
    const double expected = run_test(specimen, request, "joint", Verbosity::quiet).header.peak_axial_stress;
    specimen.contact_flaw = specimen.contact_kind;
    specimen.flaw_names = {"joint"};
    request.material.fabric.flaws["joint"].friction_angle = joint.friction_angle;
    request.material.contact.friction_angle = 50 * test::degree;
    request.contact = contact_parameters(request.material, request.plane, {});
    EXPECT_EQ(run_test(specimen, request, "joint", Verbosity::quiet).header.peak_axial_stress, expected);
}

TEST(Joint, HalfTheRateIsHalfTheSpeed) {
    const test::JointedTest joint{50 * test::degree, 5 * test::MPa};
    const Specimen specimen = joint.specimen(4, 4, test::Blocks::of_one_grain);
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
