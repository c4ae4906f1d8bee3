// The law `coulomb-slip`: strengths, residual values, what happens open, and its energies, against values by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_contact;
using test::ContactWalk;
using test::degree;
using test::expect_close;
using test::MPa;
using test::verify;

/// tc 24.15 MPa, cc 74.57 MPa, φ 48.76°; residual 3 MPa, 10 MPa, 30°.
ContactParameters with_residual() {
    ContactParameters c = augig_contact();
    c.residual_tensile_strength = 3 * MPa;
    c.residual_cohesion = 10 * MPa;
    c.residual_friction_angle = 30 * degree;
    return c;
}
ContactLaw slip_law(const ContactParameters& c) { return make_contact_law(c, LawVariant::coulomb_slip); }

TEST(CoulombSlip, TensionIsLinearAndThenGone) {
    const ContactParameters c = augig_contact();
    const ContactLaw law = slip_law(c);
    ContactWalk walk(law);
    const double strain_at_peak = c.tensile_strength / law.kt;
    walk.go({strain_at_peak * (1 - 1e-9), 0}, 10);
    verify("law: coulomb-slip, tensile strength (MPa)", walk.traction().normal / MPa, 24.15, 1e-8, "tc");
    walk.to({strain_at_peak * (1 + 1e-9), 0});
    EXPECT_EQ(walk.traction().normal, 0);
    EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);
    EXPECT_EQ(point_state(walk.history()), PointState::separated);
    expect_close(walk.fracture(), 0.5 * c.tensile_strength * strain_at_peak, 1e-8, walk.fracture());
    walk.go({-strain_at_peak, 0}, 10);
    walk.go({0.5 * strain_at_peak, 0}, 10);
    EXPECT_EQ(walk.traction().normal, 0);  // no healing
}

// Beyond its maximum closure Vm a joint is as stiff as a boundary of the rock; opened again it is soft.
TEST(CoulombSlip, AJointIsShutAtItsMaximumClosure) {
    ContactParameters c = augig_contact();
    c.maximum_closure = 2e-6;
    c.shut_stiffness = 50 * c.normal_stiffness;
    const ContactLaw law = slip_law(c);
    ContactWalk walk(law);
    for (const double closure : {1e-6, 2e-6, 5e-6, 1.5e-6}) {
        walk.go({-closure, 0}, 10);
        const double beyond = std::max(0.0, closure - 2e-6);
        const double traction = law.kt * std::min(closure, 2e-6) + 50 * law.kt * beyond;
        verify("law: coulomb-slip, traction of a joint that shuts (MPa)", -walk.traction().normal / MPa, traction / MPa, 1e-12,
               "kt Vm + k (closure - Vm)");
        const double energy =
            0.5 * law.kt * std::min(closure, 2e-6) * std::min(closure, 2e-6) + beyond * (law.kt * 2e-6 + 25 * law.kt * beyond);
        expect_close(walk.stored(), energy, 1e-12, energy);
    }
    EXPECT_EQ(law.stiffest_normal, 50 * law.kt);
    EXPECT_EQ(make_contact_law(c, LawVariant::consistent).stiffest_normal, law.kt);  // of a law without joints
}

// Open: the Coulomb line goes on into tension.
TEST(CoulombSlip, TensionLowersTheShearStrength) {
    const ContactParameters c = augig_contact();
    const ContactLaw law = slip_law(c);
    const double normal = 20 * MPa;
    const double strength = 51.7561 * MPa;  // 74.57 − 20 tan 48.76°, by hand
    ContactWalk walk(law);
    walk.go({normal / law.kt, 0}, 10);
    walk.go({normal / law.kt, strength / law.ks * (1 - 1e-5)}, 10);
    EXPECT_FALSE(walk.history().failed());
    verify("law: coulomb-slip, shear strength at 20 MPa of tension (MPa)", walk.largest_shear() / MPa, strength / MPa, 2e-5,
           "c - sigma_n tan(phi) by hand");
    const double stored = walk.stored();
    walk.to({normal / law.kt, strength / law.ks * (1 + 1e-5)});
    EXPECT_EQ(walk.traction().normal, 0);  // above the residual tension of nothing: separated
    EXPECT_EQ(walk.traction().shear, 0);
    EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);  // by the files' convention: it was open
    expect_close(walk.fracture(), stored, 5e-5, stored);
}

// Failed in shear, then opened: the residual tension is borne once, shear on the residual strength relaxes as friction.
TEST(CoulombSlip, ResidualTensionIsBorneOnceAndNothingAfter) {
    const ContactLaw law = slip_law(with_residual());
    const double closure = -20 * MPa / law.kt;
    ContactWalk walk(law);
    walk.to({closure, 0});
    walk.go({closure, 3e-6}, 2000);
    ASSERT_TRUE(walk.history().failed_closed);
    const double opening = 3 * MPa / law.kt;
    walk.go({opening * (1 - 1e-9), 3e-6}, 4000);
    verify("law: coulomb-slip, residual tensile strength (MPa)", walk.traction().normal / MPa, 3, 1e-8, "as given");
    const double limit = 10 * MPa - 3 * MPa * std::tan(30 * degree);
    expect_close(walk.traction().shear, limit, 1e-6, limit);  // the slip on the way here was in steps
    EXPECT_FALSE(walk.history().separated);
    const double fracture = walk.fracture();
    const double friction = walk.friction();
    const double stored = walk.stored();
    walk.to({opening * (1 + 1e-9), 3e-6});
    EXPECT_TRUE(walk.history().separated);
    EXPECT_EQ(walk.traction().shear, 0);
    expect_close(walk.fracture() - fracture, 0.5 * 3 * MPa * opening, 1e-8, stored);
    expect_close(walk.friction() - friction, 0.5 * limit * limit / law.ks, 1e-6, stored);
    // Closed again it pushes, slips, and holds its residual cohesion; opened again it pulls no more.
    walk.go({closure, 3e-6}, 100);
    walk.go({closure, 0}, 2000);
    const double residual = 10 * MPa + 20 * MPa * std::tan(30 * degree);
    expect_close(walk.traction().shear, -residual, 1e-12, residual);
    walk.go({0.5 * opening, 0}, 100);
    EXPECT_EQ(walk.traction().normal, 0);
    EXPECT_EQ(walk.traction().shear, 0);
    expect_close(walk.non_conservative(), 0, 1e-12, fracture);
}

}  // namespace
}  // namespace graincrack
