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

}  // namespace
}  // namespace graincrack
