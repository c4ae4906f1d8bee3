// The law `cohesive-frictional`: its curves and areas, its strength under pressure, friction that weakens with cohesion, its
// limits.
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

using test::ContactWalk;
using test::expect_close;
using test::integral;
using test::MPa;
using test::verify;
using test::weak_contact;

ContactLaw frictional_law(const ContactParameters& c) { return make_contact_law(c, LawVariant::cohesive_frictional); }
/// Sliding at which a closed point has lost its cohesion: half of it times cc is G_II less what lies under the curve up to the
/// peak beyond the triangle, δcs (1 + 2 [G_II/(cc δcs) − (e − 2)]).
double last_frictional_sliding(const ContactParameters& c) {
    return c.critical_sliding + 2 * (c.mode_ii_fracture_energy / c.cohesion - (std::numbers::e - 2) * c.critical_sliding);
}
/// A point under a compression, by its history.
ContactHistory pressed(const ContactLaw& law, double pressure) {
    ContactHistory h;
    h.motion.opening = pressure > 0 ? -pressure / law.kt : -1e-30;
    return h;
}

TEST(CohesiveFrictional, SlidingHasTheAreaGII) {
    for (const double energy : {70.0, 330.0, 1000.0}) {
        const ContactParameters c = weak_contact(energy);
        const ContactLaw law = frictional_law(c);
        ContactWalk walk(law, pressed(law, 0));
        const auto shear = [&](double s) { return walk.to({-1e-30, s}).shear; };
        verify("law: cohesive-frictional, area under sliding without pressure (J/m2)",
               integral(shear, 0, c.critical_sliding, 8) + integral(shear, c.critical_sliding, last_frictional_sliding(c), 1),
               energy, 1e-9, "G_II");
        EXPECT_EQ(walk.to({-1e-30, 1.001 * last_frictional_sliding(c)}).shear, 1e-30 * law.kt * law.tan_phi);
        EXPECT_EQ(walk.history().first_mode, CrackMode::shear);
        EXPECT_EQ(damage(law, walk.history()), 1);
    }
}

TEST(CohesiveFrictional, OpeningHasTheAreaGf) {
    const ContactParameters c = weak_contact();
    const ContactLaw law = frictional_law(c);
    ContactWalk walk(law);
    const auto normal = [&](double o) { return walk.to({o, 0}).normal; };
    const double last =
        c.critical_opening * (1 + 2 * (c.fracture_energy / (c.tensile_strength * c.critical_opening) - (std::numbers::e - 2)));
    verify("law: cohesive-frictional, area under opening (J/m2)",
           integral(normal, 0, c.critical_opening, 8) + integral(normal, c.critical_opening, last, 1), c.fracture_energy, 1e-9,
           "Gf");
    EXPECT_EQ(walk.to({1.001 * last, 0}).normal, 0);
    EXPECT_EQ(point_state(walk.history()), PointState::separated);
}

// With a residual friction angle friction weakens as cohesion does.
TEST(CohesiveFrictional, FrictionWeakensWithCohesion) {
    ContactParameters c = weak_contact();
    c.residual_friction_angle = 30 * test::degree;
    const ContactLaw law = frictional_law(c);
    const double pressure = 20 * MPa;
    ContactWalk walk(law, pressed(law, pressure));
    const double opening = walk.history().motion.opening;
    for (const double lost : {0.3, 0.6, 0.9}) {
        const double sliding = c.critical_sliding + lost * (last_frictional_sliding(c) - c.critical_sliding);
        const double tan_phi = (1 - lost) * law.tan_phi + lost * std::tan(30 * test::degree);
        verify("law: cohesive-frictional, traction while friction weakens (MPa)", walk.go({opening, sliding}, 2000).shear / MPa,
               (c.cohesion * (1 - lost) + pressure * tan_phi) / MPa, 1e-9, "both in proportion to 1 − D");
        expect_close(damage(law, walk.history()), lost, 1e-9, 1);
    }
    walk.go({opening, 2 * last_frictional_sliding(c)}, 20000);
    expect_close(walk.traction().shear, pressure * std::tan(30 * test::degree), 1e-12, pressure);
    EXPECT_TRUE(contact_law::CohesiveFrictional::is_residual(law, walk.history()));
    EXPECT_GE(walk.min_friction(), 0);
    const double stored_at_first = 0.5 * pressure * pressure / law.kt;
    expect_close(walk.balance(), -stored_at_first, 1e-6, walk.work());  // trapezia: 5.5e-7 with these steps
}

// Below the energy of the way to the peak nothing softens: under pressure the law is `consistent`.
TEST(CohesiveFrictional, SuddenLossIsTheLimitOfSmallEnergies) {
    const double least = (std::numbers::e - 2) * weak_contact().cohesion * weak_contact().critical_sliding;
    const ContactParameters c = weak_contact(0.9 * least);
    const ContactLaw law = frictional_law(c);
    EXPECT_FALSE(law.softens_in_shear);
    EXPECT_TRUE(frictional_law(weak_contact(1.1 * least)).softens_in_shear);
    const ContactLaw consistent = make_contact_law(c, LawVariant::consistent);
    for (const double pressure : {5.0, 50.0}) {
        ContactWalk here(law, pressed(law, pressure * MPa));
        ContactWalk there(consistent, pressed(law, pressure * MPa));
        for (int k = 1; k < 400; ++k) {
            const ContactMotion to{here.history().motion.opening, 3 * c.critical_sliding * std::sin(0.02 * k)};
            here.to(to);
            there.to(to);
            EXPECT_EQ(here.traction().shear, there.traction().shear);
        }
        EXPECT_TRUE(here.history().failed());
        expect_close(here.fracture(), there.fracture(), 1e-12, there.fracture());
        expect_close(here.friction(), there.friction(), 1e-12, there.friction());
    }
}

}  // namespace
}  // namespace graincrack
