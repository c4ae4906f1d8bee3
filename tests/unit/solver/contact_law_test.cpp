// The contact law point by point; paths and energies are in tests/physics.
#include "solver/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"

namespace graincrack {
namespace {

using test::all_laws;
using test::augig_contact;
using test::expect_close;

TEST(ContactLawPoint, ConstantsFromTheParameters) {
    const ContactParameters p = augig_contact();
    const ContactLaw literal = make_contact_law(p, LawVariant::literal, Coupling::none);
    EXPECT_EQ(literal.w, 1);
    EXPECT_EQ(literal.kt, p.normal_stiffness);
    EXPECT_EQ(literal.dut, p.ultimate_opening);
    EXPECT_EQ(literal.coupling, Coupling::none);
    expect_close(literal.tan_phi, std::tan(48.76 * std::numbers::pi / 180), 1e-15, 1);
    const ContactLaw scaled = make_contact_law(p, LawVariant::scaled, Coupling::full);
    expect_close(scaled.w, p.shear_stiffness / p.normal_stiffness, 1e-15, 1);
    expect_close(scaled.inv_dct * scaled.dct, 1, 1e-15, 1);
    EXPECT_EQ(name_of(LawVariant::continuous), "continuous");
    EXPECT_EQ(name_of(Coupling::none), "none");
}

TEST(ContactLawPoint, AtRestThereIsNothing) {
    for (const ContactLaw& law : all_laws(augig_contact())) {
        const ContactResponse r = update_contact(law, {0, 0}, {});
        EXPECT_EQ(r.traction.normal, 0);
        EXPECT_EQ(r.traction.shear, 0);
        EXPECT_EQ(stored_energy(law, r.history), 0);
        EXPECT_EQ(point_state(r.history), PointState::intact);
        EXPECT_EQ(damage(law, r.history), 0);
    }
}

TEST(ContactLawPoint, PeakTractionsAndFirstMode) {
    const ContactParameters p = augig_contact();
    for (const ContactLaw& law : all_laws(p)) {
        const ContactResponse at_peak = update_contact(law, {p.critical_opening * (1 - 1e-12), 0}, {});
        expect_close(at_peak.traction.normal, p.tensile_strength, 1e-12, p.tensile_strength);
        EXPECT_FALSE(at_peak.history.failed());
        const ContactResponse past = update_contact(law, {p.critical_opening * 1.01, 0}, at_peak.history);
        EXPECT_EQ(point_state(past.history), PointState::failed_tension);
        EXPECT_LT(past.traction.normal, p.tensile_strength);
        const ContactResponse gone = update_contact(law, {p.ultimate_opening * 1.01, 0}, past.history);
        EXPECT_EQ(point_state(gone.history), PointState::separated);
        EXPECT_EQ(damage(law, gone.history), 1);
    }
}

// A closed contact pushes with kt whatever has happened to it.
TEST(ContactLawPoint, ClosedPushesWithInitialStiffness) {
    for (const ContactLaw& law : all_laws(augig_contact())) {
        for (const ContactHistory& h : {ContactHistory{}, broken_contact()}) {
            EXPECT_EQ(update_contact(law, {-1e-8, 0}, h).traction.normal, -1e-8 * law.kt);
        }
    }
}

// The shear strength of a contact that is open by nothing is what tells the readings apart: tc, tc √κ, cc.
TEST(ContactLawPoint, ShearStrengthWhileOpen) {
    const ContactParameters p = augig_contact();
    for (const ContactLaw& law : all_laws(p)) {
        test::ContactWalk walk(law);
        walk.go({0, 1.5 * p.critical_sliding}, 100000);
        const double kappa = p.shear_stiffness / p.normal_stiffness;
        const double strength = law.variant == LawVariant::literal  ? p.tensile_strength
                                : law.variant == LawVariant::scaled ? p.tensile_strength * std::sqrt(kappa)
                                                                    : p.cohesion;
        expect_close(walk.largest_shear(), strength, 1e-4, strength);
        EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);  // open then
    }
}

TEST(ContactLawPoint, PreExistingCracksAreBrokenInEveryReading) {
    for (const ContactLaw& law : all_laws(augig_contact())) {
        const ContactHistory h = broken_contact();
        EXPECT_EQ(point_state(h), PointState::separated);
        EXPECT_EQ(damage(law, h), 1);
        EXPECT_EQ(stored_energy(law, h), 0);
        const ContactResponse open = update_contact(law, {1e-8, 1e-7}, h);
        EXPECT_EQ(open.traction.normal, 0);
        EXPECT_EQ(open.traction.shear, 0);
        EXPECT_EQ(open.dissipation.fracture, 0);
    }
}

// The branch-free law of intact points gives what `update_contact` gives.
TEST(ContactLawPoint, IntactLawAgreesWithTheFullOne) {
    for (const ContactLaw& law : all_laws(augig_contact())) {
        const IntactLaw intact = make_intact_law(law);
        int inside = 0;
        for (double opening = -3; opening < 1.3; opening += 0.17) {
            for (double sliding = -2; sliding < 2; sliding += 0.13) {
                const ContactMotion to{opening * law.dct, sliding * (opening < 0 ? law.dcs : law.dct)};
                const IntactTraction t = intact_traction(intact, to.opening, to.sliding);
                ContactHistory before;
                before.motion.opening = opening < 0 ? -1e-12 : 0;
                const ContactResponse r = update_contact(law, to, before);
                EXPECT_EQ(r.history.failed(), t.load > 1);
                if (t.load <= 1) {
                    expect_close(t.normal, r.traction.normal, 1e-15, law.tc);
                    expect_close(t.shear, r.traction.shear, 1e-15, law.tc);
                    ++inside;
                }
            }
        }
        EXPECT_GT(inside, 100);
    }
}

TEST(ContactLawPoint, SmallDisplacementsHaveTheEnergyOfASpring) {
    using contact_law::exponential_energy;
    // [1 − (1 + x) e^(−x)]/x² by its series and its formula, where they meet
    for (const double x : {0.01999, 0.02001}) {
        const double series = 0.5 - x / 3 + x * x / 8 - x * x * x / 30 + x * x * x * x / 144;
        expect_close(exponential_energy(x, std::exp(-x)), series, 5e-9, 0.5);
    }
    EXPECT_EQ(exponential_energy(0, 1), 0.5);
}

}  // namespace
}  // namespace graincrack
