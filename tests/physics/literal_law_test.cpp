// The law `literal`: no mesh, no dynamics. Numbers are those of Augig granite with tc 24.15 MPa, cc 74.57 MPa, φc 48.76°,
// mixed-mode fracture energy, plane strain, computed from Eqs 3–14 by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/gauss.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_contact;
using test::ContactWalk;
using test::expect_close;
using test::integral;
using test::mm;
using test::MPa;
using test::verify;

ContactLaw literal_law(const ContactParameters& c) { return make_contact_law(c, LawVariant::literal); }

TEST(LiteralLaw, AreaUnderOpeningIsTheFractureEnergy) {
    const ContactParameters c = augig_contact();
    ContactWalk walk(literal_law(c));
    const auto traction = [&](double opening) { return walk.to({opening, 0}).normal; };
    const double before = integral(traction, 0, c.critical_opening, 8);
    const double after = integral(traction, c.critical_opening, c.ultimate_opening, 8);
    verify("law: area under opening (J/m2)", before + after, c.fracture_energy, 1e-9, "Gf, Eqs 14, 32");
    verify("law: area under opening as printed (J/m2)", before + after, 412.97965, 1e-7, "Eq 32 by hand, eight digits");
    expect_close(before, c.tensile_strength * c.critical_opening * (std::numbers::e - 2), 1e-12, before);
    verify("law: its part before the peak over Gf", before / c.fracture_energy, 0.0040, 0.0125, "tc dct (e - 2)/Gf, two digits");
    EXPECT_EQ(walk.to({c.ultimate_opening * 1.001, 0}).normal, 0);
    EXPECT_TRUE(walk.history().separated);
}

TEST(LiteralLaw, ShearUnderPressurePeaksAtTheCohesion) {
    const ContactParameters c = augig_contact();
    const ContactLaw law = literal_law(c);
    verify("law: critical sliding (mm)", c.critical_sliding / mm, 2.9025e-3, 2e-5, "Eq 11, five digits");
    for (const double pressure : {1 * MPa, 20 * MPa, 100 * MPa}) {
        const double closure = -pressure / law.kt;
        ContactWalk walk(law);
        walk.to({closure, 0});
        double largest = 0;
        const auto traction = [&](double s) {
            const ContactTraction t = walk.to({closure, s});
            expect_close(t.normal, -pressure, 1e-14, pressure);
            largest = std::max(largest, t.shear);
            return t.shear;
        };
        const double energy = integral(traction, 0, c.critical_sliding, 8);
        verify("law: shear to its peak under pressure (J/m2)", energy, 155.46, 5e-5, "cc dcs (e - 2), five digits");
        expect_close(energy, c.cohesion * c.critical_sliding * (std::numbers::e - 2), 1e-12, energy);
        verify("law: shear peak at any pressure (MPa)", traction(c.critical_sliding * (1 - 1e-12)) / MPa, c.cohesion / MPa, 1e-11,
               "cc, Eq 10");
        EXPECT_LE(largest, c.cohesion * (1 + 1e-14));
        EXPECT_FALSE(walk.history().failed());
        traction(c.critical_sliding * (1 + 1e-12));
        EXPECT_TRUE(walk.history().failed_closed);
        EXPECT_EQ(walk.history().first_mode, CrackMode::shear);
    }
}

TEST(LiteralLaw, FailedContactUnderPressureKeepsFriction) {
    const ContactParameters c = augig_contact();
    const ContactLaw law = literal_law(c);
    const auto residual = [&](double pressure) {
        ContactWalk walk(law);
        walk.to({-pressure / law.kt, 0});
        return walk.go({-pressure / law.kt, 4 * c.critical_sliding}, 4000).shear;
    };
    // tolerances: the digits printed
    verify("law: residual shear at 20 MPa (MPa)", residual(20 * MPa) / MPa, 22.814, 3e-5, "tan(phi) sigma_n, Eq 12");
    verify("law: residual shear at 30 MPa (MPa)", residual(30 * MPa) / MPa, 34.2, 1e-3, "tan(phi) sigma_n, Eq 12");
    verify("law: residual shear at 100 MPa (MPa)", residual(100 * MPa) / MPa, 114.1, 1e-3, "tan(phi) sigma_n, Eq 12");
    EXPECT_GT(residual(100 * MPa), c.cohesion);  // it hardens
}

TEST(LiteralLaw, LoopsAtTheResidualDissipateTractionTimesSlip) {
    const ContactParameters c = augig_contact();
    const ContactLaw law = literal_law(c);
    const double residual = 20 * MPa * std::tan(c.friction_angle);
    const double closure = -20 * MPa / law.kt;
    const double reach = 3 * c.critical_sliding;
    ContactWalk walk(law);
    walk.to({closure, 0});
    walk.go({closure, reach}, 2000);
    const ContactTraction before = walk.traction();
    const ContactTraction after = walk.to({closure, reach - 1e-3 * c.critical_sliding});
    verify("law: unloading slope of friction (Pa/m)", (before.shear - after.shear) / (1e-3 * c.critical_sliding), law.ks, 1e-10,
           "ks");
    walk.to({closure, reach});
    const double work = walk.work();
    const double friction = walk.friction();
    walk.go({closure, -reach}, 8000);
    verify("law: friction after slip is reversed (MPa)", walk.traction().shear / MPa, -residual / MPa, 1e-11, "changes its sign");
    walk.go({closure, reach}, 8000);
    expect_close(walk.traction().shear, residual, 1e-12, residual);
    const double slip = 2 * (2 * reach - 2 * residual / law.ks);
    EXPECT_GT(slip, 0);
    // trapezia at the four corners of the loop: 4e-8
    verify("law: loop at the residual, dissipation (J/m2)", walk.friction() - friction, residual * slip, 1e-6,
           "traction times slip");
    expect_close(walk.work() - work, residual * slip, 1e-6, residual * slip);
}

// At δn = 0 an intact contact that carries shear goes from Eq 10 to Eqs 7 and 13: τ jumps from ks δs e^(−δs/δcs) up to
// kt δs e^(−δs/δct), by nearly kt/ks = 9.8, and a loop makes energy.
TEST(LiteralLaw, CrossingOfTheOpenBoundaryBeforeDamage) {
    const ContactParameters c = augig_contact();
    const ContactLaw law = literal_law(c);
    const double s = 0.5 * c.critical_opening;
    const auto energy = [](double k, double d, double peak) {  // of Eq 7 or 10
        return k * peak * peak * (1 - (1 + d / peak) * std::exp(-d / peak));
    };
    const double closed = law.ks * s * std::exp(-s / c.critical_sliding);
    const double open = law.kt * s * std::exp(-s / law.dct);
    // by a loop: closed at 0, slide, open, slide back, close
    const double made = energy(law.kt, s, law.dct) - energy(law.ks, s, law.dcs);
    const double tiny = 1e-12 * c.critical_opening;
    ContactWalk walk(law);
    walk.to({-tiny, 0});
    expect_close(walk.go({-tiny, s}, 4000).shear, closed, 1e-10, closed);
    verify("law: shear on opening over that before, literal", walk.to({tiny, s}).shear / closed, open / closed, 1e-10,
           "the variant's branches at opening 0");
    walk.go({tiny, 0}, 4000);
    walk.to({-tiny, 0});
    EXPECT_FALSE(walk.history().failed());
    // The trapezia of 4000 steps: below 1e-7. The crossing itself is a leg without length.
    const double scale = energy(law.ks, s, law.dcs);
    expect_close(walk.work(), -made, 1e-6, scale);
    expect_close(walk.non_conservative(), -made, 1e-6, scale);
    EXPECT_EQ(walk.fracture(), 0);
    EXPECT_EQ(walk.friction(), 0);
    EXPECT_GT(made, 2 * scale);
}

// Of a contact that failed in shear under pressure nothing is left when it opens.
TEST(LiteralLaw, OpeningAfterShearFailure) {
    const ContactParameters c = augig_contact();
    const ContactLaw law = literal_law(c);
    ContactWalk walk(law);
    walk.to({-20 * MPa / law.kt, 0});
    walk.go({-20 * MPa / law.kt, 1.5 * c.critical_sliding}, 2000);
    ASSERT_TRUE(walk.history().failed_closed);
    walk.go({-20 * MPa / law.kt, 0}, 2000);
    EXPECT_EQ(walk.go({0.2 * c.critical_opening, 0}, 2000).normal, 0);
    EXPECT_TRUE(walk.history().separated);
    EXPECT_EQ(damage(law, walk.history()), 1);
    EXPECT_EQ(point_state(walk.history()), PointState::separated);
}

}  // namespace
}  // namespace graincrack
