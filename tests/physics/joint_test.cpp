// A plane of weakness at the automatic rate: it slides at its static strength, and neither inertia nor damping carries load.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "solver/run/sensitivity.hpp"
#include "solver/setup/setup.hpp"
#include "tests/support/check.hpp"
#include "tests/support/jointed_test.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

// Two blocks on a joint: the peak is Jaeger's strength (tests/support/jointed_test.hpp) to 1 %; damping
// carries 0.2 % of the load at most: inertia and damping that the automatic rate allows.
TEST(Joint, SlidesAtJaegersStrengthWithDefaultOptions) {
    for (const double angle : {50.0, 62.0}) {
        for (const double pressure : {5.0, 20.0}) {
            const JointedTest joint{angle * degree, pressure * MPa};
            const Specimen specimen = joint.specimen(6, 6, Blocks::of_one_grain);
            const TestOutcome outcome = run_test(specimen, joint.request(), "joint", Verbosity::quiet);
            const std::string name = fmt::format("two blocks, {} deg, {} MPa", angle, pressure);
            EXPECT_EQ(outcome.header.stop_reason, "strain limit");  // it slid on at its strength
            verify("specimens: strength of a joint, " + name + " (MPa)", outcome.header.peak_axial_stress / MPa,
                   joint.strength() / MPa, 0.01, "Jaeger (1960), to 1 %");
            verify("specimens: load that damping carries on a joint, " + name, outcome.header.damping_load, 0, 0.002,
                   "what the automatic rate allows", 1);
        }
    }
}

JointedTest plane_of_a_class(double angle, double pressure) { return {angle * degree, pressure * MPa, 30 * degree, 10 * MPa}; }
TestOutcome outcome_of(const JointedTest& plane, LawVariant law) {
    SimulationRequest request = plane.request();
    request.law = law;
    request.peak_drop = 0;
    return run_test(plane.specimen(4, 4, Blocks::of_one_grain), request, "plane", Verbosity::quiet);
}

// The class of two phases is weak and that of each with itself strong: the plane where they meet slides with the values of its
// class. Friction adds to cohesion; coulomb-slip then loses all cohesion at once.
TEST(Joint, OfAClassSlidesAtJaegersStrengthWithCohesionAndFriction) {
    for (const LawVariant law : {LawVariant::cohesive_frictional, LawVariant::coulomb_slip}) {
        for (const auto& [angle, pressure] : {std::pair{50.0, 5.0}, std::pair{60.0, 20.0}}) {
            const JointedTest plane = plane_of_a_class(angle, pressure);
            verify(fmt::format("phases: plane of a class, {}, {} deg, {} MPa (MPa)", name_of(law), angle, pressure),
                   outcome_of(plane, law).header.peak_axial_stress / MPa, plane.strength() / MPa, 0.01, "Jaeger (1960), to 1 %");
        }
    }
}

// In the law of the paper friction comes after cohesion: the peak is that of cohesion alone, what follows is that of friction.
TEST(Joint, OfAClassSlidesAtItsCohesionAndThenAtItsFrictionWithTheDefaultLaw) {
    const JointedTest plane = plane_of_a_class(60, 5);
    JointedTest cohesion = plane;
    cohesion.friction_angle = 0;
    JointedTest friction = plane;
    friction.cohesion = 0;
    const TestOutcome outcome = outcome_of(plane, SimulationRequest{}.law);
    verify("phases: plane of a class, consistent, 60 deg, 5 MPa, peak (MPa)", outcome.header.peak_axial_stress / MPa,
           cohesion.strength() / MPa, 0.02, "Jaeger with cohesion alone");
    verify("phases: plane of a class, consistent, 60 deg, 5 MPa, at the end (MPa)",
           -outcome.history[HistoryColumn::axial_stress].back() / MPa, friction.strength() / MPa, 0.01,
           "Jaeger with friction alone");
}

// Only the joint can slide: whether its class or the whole rock has its friction, it does so at the same strength, also where
// grains meet others than those that they were bonded to.
TEST(Joint, SlidesAtTheFrictionOfItsClass) {
    const JointedTest joint{50 * degree, 5 * MPa};
    Specimen specimen = joint.specimen(6, 6, Blocks::of_grains);
    SimulationRequest request = joint.request();
    request.mass_scaling = true;
    const double expected = run_test(specimen, request, "joint", Verbosity::quiet).header.peak_axial_stress;
    specimen.contact_flaw = specimen.contact_kind;
    specimen.flaw_names = {"joint"};
    request.material.fabric.flaws["joint"].friction_angle = joint.friction_angle;
    request.material.contact.friction_angle = 50 * degree;
    request.contact = contact_parameters(request.material, request.plane, {});
    EXPECT_EQ(run_test(specimen, request, "joint", Verbosity::quiet).header.peak_axial_stress, expected);
}

// Where the measures hold the speed they follow it to the lag of the control, a few per cent; everywhere else it is halved.
TEST(Joint, SlidesAtHalfTheSpeedAtHalfTheRate) {
    const JointedTest joint{50 * degree, 5 * MPa};
    const Specimen specimen = joint.specimen(4, 4, Blocks::of_one_grain);
    const SimulationRequest request = joint.request();
    const auto speed_of = [&specimen](const SimulationRequest& r) {
        return run_test(specimen, r, "joint", Verbosity::quiet).header.platen_speed;
    };
    const double whole = speed_of(request);
    expect_close(speed_of(sensitivity_cases(request, program_of(request, specimen), 0)[0].request), whole / 2, 0.05, whole / 2);
}

}  // namespace
}  // namespace graincrack::test
