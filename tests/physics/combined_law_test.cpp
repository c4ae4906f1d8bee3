// The law `combined`: Munjiza's curve, its energies in both modes, their interaction, and friction beside cohesion.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/gauss.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using contact_law::munjiza_softening;
using test::augig_contact;
using test::ContactWalk;
using test::expect_close;
using test::integral;
using test::MPa;
using test::verify;
using test::verify_between;

ContactParameters parameters() { return augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i); }
ContactLaw combined_law(const ContactParameters& c) { return make_contact_law(c, LawVariant::combined); }
/// o_r and s_r, m.
double last_opening(const ContactLaw& law) { return law.op * (1 + law.o_range); }
double last_combined_sliding(const ContactLaw& law) { return law.sp * (1 + law.s_range); }

/// z as Munjiza, Andrews & White (1999) print it.
double printed_softening(double D) {
    const double a = 0.63;
    const double b = 1.8;
    const double c = 6;
    return (1 - (a + b - 1) / (a + b) * std::exp(D * (a + c * b) / ((a + b) * (1 - a - b)))) *
           (a * (1 - D) + b * std::pow(1 - D, c));
}

TEST(CombinedLaw, TheCurveIsMunjizas) {
    double before = 1;
    for (double D = 0; D <= 1; D += 1.0 / 64) {
        verify("law: combined, softening curve z(D)", munjiza_softening(D), printed_softening(D), 1e-14, "as printed", 1);
        EXPECT_LE(munjiza_softening(D), before);
        before = munjiza_softening(D);
    }
    EXPECT_EQ(munjiza_softening(1), 0);
    EXPECT_EQ(munjiza_softening(1.5), 0);
    verify("law: combined, area under z", integral(printed_softening, 0, 1, 16), contact_law::softening_area, 1e-13,
           "closed form in combined.hpp");
}

TEST(CombinedLaw, ThePartsOfTheCurveInOpening) {
    const ContactParameters c = parameters();
    const ContactLaw law = combined_law(c);
    ContactWalk walk(law);
    for (const double x : {0.2, 0.7, 1.0}) {
        expect_close(walk.to({x * law.op, 0}).normal, c.tensile_strength * x * (2 - x), 1e-14, c.tensile_strength);
    }
    EXPECT_FALSE(walk.history().failed());
    EXPECT_EQ(walk.fracture(), 0);  // elastic so far
    walk.go({0.3 * law.op, 0}, 10);
    expect_close(walk.traction().normal, c.tensile_strength * 0.3 * 1.7, 1e-14, c.tensile_strength);
    for (const double D : {0.1, 0.4, 0.8}) {
        const double opening = law.op + D * (last_opening(law) - law.op);
        expect_close(walk.to({opening, 0}).normal, c.tensile_strength * printed_softening(D), 1e-12, c.tensile_strength);
        expect_close(damage(law, walk.history()), D, 1e-12, 1);
        const double split = walk.traction().normal;
        expect_close(walk.to({0.25 * opening, 0}).normal, 0.25 * split, 1e-12, split);  // the secant
        expect_close(walk.to({opening, 0}).normal, split, 1e-12, split);
    }
    EXPECT_EQ(walk.to({1.001 * last_opening(law), 0}).normal, 0);
    EXPECT_EQ(point_state(walk.history()), PointState::separated);
}

TEST(CombinedLaw, AreasAreTheFractureEnergies) {
    const ContactParameters c = parameters();
    const ContactLaw law = combined_law(c);
    ContactWalk opened(law);
    const auto normal = [&](double o) { return opened.to({o, 0}).normal; };
    verify("law: combined, area under opening (J/m2)",
           integral(normal, 0, law.op, 4) + integral(normal, law.op, last_opening(law), 40), c.fracture_energy, 1e-9, "G_I");
    expect_close(c.fracture_energy, 82.6, 1e-3, 82.6);  // three digits of MODEL: K_IC²/Ẽ
    for (const double opening : {0.0, -1e-30}) {        // in shear: at zero opening: open, closed
        ContactHistory start;
        start.motion.opening = opening;
        ContactWalk slid(law, start);
        const auto shear = [&](double s) { return slid.to({opening, s}).shear; };
        verify("law: combined, area under sliding (J/m2)",
               integral(shear, 0, law.sp, 4) + integral(shear, law.sp, last_combined_sliding(law), 40), c.mode_ii_fracture_energy,
               1e-9, "G_II");
        expect_close(slid.to({opening, 1.001 * last_combined_sliding(law)}).shear, 0, 1e-15, c.cohesion);  // friction of 1e-30 m
        EXPECT_TRUE(slid.history().separated);
    }
    expect_close(c.mode_ii_fracture_energy, 4 * c.fracture_energy, 1e-12, c.fracture_energy);  // (K_IIC/K_IC)² = 4
}

// Where the largest opening and sliding are the present ones, the tractions are z of the joint D.
TEST(CombinedLaw, TheModesInteract) {
    const ContactParameters c = parameters();
    const ContactLaw law = combined_law(c);
    for (const double share : {0.1, 0.3, 0.6}) {
        ContactWalk walk(law);
        const double opening = law.op + share * (last_opening(law) - law.op);
        const double sliding = law.sp + 0.5 * (last_combined_sliding(law) - law.sp);
        walk.go({opening, -sliding}, 100);
        const double z = printed_softening(std::sqrt(share * share + 0.25));
        verify("law: combined, tractions under both modes over strength", walk.traction().normal / c.tensile_strength, z, 1e-12,
               "z(D)", 1);
        verify("law: combined, tractions under both modes over strength", walk.traction().shear / c.cohesion, -z, 1e-12, "z(D)",
               1);
        EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);
    }
}

// Failed open and closed again: friction from zero, on all of the area, with what cohesion is left.
TEST(CombinedLaw, ClosingAfterOpening) {
    const ContactParameters c = parameters();
    const ContactLaw law = combined_law(c);
    ContactWalk walk(law);
    const double opening = law.op + 0.5 * (last_opening(law) - law.op);
    walk.go({opening, 0}, 1000);
    const double closure = -20 * MPa / law.kt;
    walk.go({closure, 0}, 1000);
    expect_close(walk.traction().normal, -20 * MPa, 1e-12, 20 * MPa);
    EXPECT_EQ(walk.traction().shear, 0);
    walk.go({closure, 0.5 * law.sp}, 1000);
    const double z = printed_softening(0.5);
    expect_close(walk.traction().shear, z * c.cohesion * 0.75 + 20 * MPa * std::tan(c.friction_angle), 1e-12, c.cohesion);
}

}  // namespace
}  // namespace graincrack
