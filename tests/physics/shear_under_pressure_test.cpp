// A contact point that slides under pressure, for every law: its strength, what is left of it, friction on a loop, and nothing
// when it opens.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::degree;
using test::MPa;
using test::verify;

struct Sheared {
    ContactLaw law;
    double peak, residual;    ///< Pa
    double far;               ///< sliding at which only the residual is left, m
    std::string source;       ///< of the peak
    double tolerance = 2e-4;  ///< of the peak: steps
    double fracture = NAN;    ///< energy of the fall, J/m²; NaN: not compared
};

/// Cohesion first, friction after it: it hardens where that is more.
Sheared paper_row(LawVariant variant, double pressure) {
    const ContactParameters c = test::augig_contact();
    const double friction = pressure * std::tan(c.friction_angle);
    return {make_contact_law(c, variant), std::max(c.cohesion, friction), friction, 4 * c.critical_sliding, "cc, Eq 10"};
}
/// Friction is mobilised while cohesion softens by z: the peak is between what is left then and the sum of both.
Sheared combined_row(double pressure) {
    const ContactParameters c = test::augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i);
    const ContactLaw law = make_contact_law(c, LawVariant::combined);
    const double friction = pressure * std::tan(c.friction_angle);
    const double last = law.sp * (1 + law.s_range);
    const double least = contact_law::munjiza_softening(friction / law.ks / (last - law.sp)) * c.cohesion + friction;
    return {law,
            least,
            friction,
            1.1 * last,
            "between z(D) cc + p tan phi and their sum",
            (c.cohesion + friction) / least - 1 + 2e-4,
            c.mode_ii_fracture_energy};
}
/// Cohesion falls on a line while friction rises on one; the strength is where friction reaches its limit.
Sheared frictional_row(double energy, double pressure) {
    const ContactParameters c = test::weak_contact(energy);
    const ContactLaw law = make_contact_law(c, LawVariant::cohesive_frictional);
    const double softening = 2 * (energy / c.cohesion - (std::numbers::e - 2) * c.critical_sliding);
    const double limit = pressure * law.tan_phi;
    return {law, c.cohesion * (1 - limit / law.ks / softening) + limit, limit, 1.1 * (c.critical_sliding + softening),
            "cc (1 − Δ/(s δcs)) + p tan φc"};
}
/// Both at once, and both fall at once to their residual values.
Sheared coulomb_row(double pressure) {
    ContactParameters c = test::augig_contact();
    c.residual_tensile_strength = 3 * MPa;
    c.residual_cohesion = 10 * MPa;
    c.residual_friction_angle = 30 * degree;
    const ContactLaw law = make_contact_law(c, LawVariant::coulomb_slip);
    const double peak = c.cohesion + pressure * std::tan(c.friction_angle);
    const double residual = c.residual_cohesion + pressure * std::tan(c.residual_friction_angle);
    return {
        law, peak, residual, 3 * peak / law.ks, "c + sigma_n tan(phi)", 2e-4, 0.5 * (peak * peak - residual * residual) / law.ks};
}

TEST(ShearUnderPressure, HasItsStrengthAndThenItsResidual) {
    for (const double pressure : {5 * MPa, 20 * MPa, 100 * MPa}) {
        for (const Sheared& row :
             {paper_row(LawVariant::literal, pressure), paper_row(LawVariant::consistent, pressure), combined_row(pressure),
              frictional_row(70, pressure), frictional_row(1000, pressure), coulomb_row(pressure)}) {
            const std::string name = "law: " + std::string(name_of(row.law.variant)) + ", shear under pressure, ";
            SCOPED_TRACE(name);
            const double closure = -pressure / row.law.kt;
            test::ContactWalk walk(row.law);
            walk.to({closure, 0});
            walk.go({closure, row.far}, 20000);
            verify(name + "peak (MPa)", walk.largest_shear() / MPa, row.peak / MPa, row.tolerance, row.source);
            verify(name + "residual (MPa)", walk.traction().shear / MPa, row.residual / MPa, 1e-9, "friction, residual cohesion");
            EXPECT_TRUE(walk.history().failed_closed);
            EXPECT_EQ(walk.history().first_mode, CrackMode::shear);
            if (!std::isnan(row.fracture)) {
                verify(name + "energy of the fall (J/m2)", walk.fracture(), row.fracture, 1e-3, "closed form");
            }
            const double friction = walk.friction();
            const double work = walk.work();
            walk.go({closure, -row.far}, 20000);
            test::expect_close(walk.traction().shear, -row.residual, 1e-9, row.residual);
            walk.go({closure, row.far}, 20000);
            const double slip = 2 * (2 * row.far - 2 * row.residual / row.law.ks);
            EXPECT_GT(slip, 0);
            verify(name + "loop at the residual, dissipation (J/m2)", walk.friction() - friction, row.residual * slip, 1e-5,
                   "traction times slip");
            test::expect_close(walk.work() - work, walk.friction() - friction, 1e-5, row.residual * slip);
            walk.go({0.2 * row.law.dct, row.far}, 2000);
            EXPECT_EQ(walk.traction().normal, 0);
            EXPECT_EQ(point_state(walk.history()), PointState::separated);
            EXPECT_EQ(damage(row.law, walk.history()), 1);
        }
    }
}

}  // namespace
}  // namespace graincrack
