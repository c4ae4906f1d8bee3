// The variant `consistent` of the contact law: the paper's curves, an energy, no non-conservative work.
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
using test::MPa;
using test::verify;

ContactLaw consistent_law(const ContactParameters& c) { return make_contact_law(c, LawVariant::consistent); }

TEST(ConsistentLaw, PureOpeningIsEq7) {
    const ContactParameters c = augig_contact();
    ContactWalk walk(consistent_law(c));
    for (const double x : {0.1, 0.5, 0.9, 1.0}) {
        const double opening = x * c.critical_opening;
        const double traction = c.normal_stiffness * opening * std::exp(-x);
        expect_close(walk.to({opening, 0}).normal, traction, 1e-14, c.tensile_strength);
    }
    for (const double d : {0.1, 0.5, 0.9}) {
        const double opening = c.critical_opening + d * (c.ultimate_opening - c.critical_opening);
        expect_close(walk.to({opening, 0}).normal, (1 - d) * c.tensile_strength, 1e-12, c.tensile_strength);
        expect_close(damage(consistent_law(c), walk.history()), d, 1e-12, 1);
    }
    EXPECT_EQ(walk.to({1.001 * c.ultimate_opening, 0}).normal, 0);
    EXPECT_TRUE(walk.history().separated);
}

// Every direction of opening takes Gf.
TEST(ConsistentLaw, EveryDirectionOfOpeningTakesTheFractureEnergy) {
    for (const auto kind : {FractureEnergyChoice::Kind::mixed, FractureEnergyChoice::Kind::mode_i}) {
        const ContactParameters c = augig_contact(PlaneCondition::strain, kind);
        const ContactLaw law = consistent_law(c);
        for (const double degrees : {0.0, 20.0, 45.0, 70.0, 89.0}) {
            const double n = std::cos(degrees * std::numbers::pi / 180);
            const double t = std::sin(degrees * std::numbers::pi / 180);
            ContactWalk walk(law);
            const auto along = [&](double reach) {
                const ContactTraction traction = walk.to({reach * n, reach * t});
                return n * traction.normal + t * traction.shear;
            };
            // λ = 1, and at λu, where no strength is left: Gf = tears · [(1 − 2/e) + (λu − 1)/(2 e)], tears = q/λ²
            const double peak = 1 / std::hypot(n * law.inv_dct, t * law.inv_dso);
            const double tears = (law.kt * n * n + law.ks * t * t) * peak * peak;
            const double last = peak * (1 + 2 * std::numbers::e * (c.fracture_energy / tears - (1 - 2 / std::numbers::e)));
            const double work = integral(along, 0, peak, 8) + integral(along, peak, last, 8);
            verify("law: consistent, area under opening in five directions (J/m2)", work, c.fracture_energy, 1e-9, "Gf, Eq 32");
            EXPECT_EQ(along(1.001 * last), 0);
            EXPECT_TRUE(walk.history().separated);
            ContactWalk steps(law);
            steps.go({1.001 * last * n, 1.001 * last * t}, 20000);
            expect_close(steps.fracture(), c.fracture_energy, 1e-4, c.fracture_energy);  // trapezia
        }
    }
}

TEST(ConsistentLaw, SlidingUnderPressureIsEq10) {
    const ContactParameters c = augig_contact();
    const double closure = -20 * MPa / c.normal_stiffness;
    ContactWalk walk(consistent_law(c));
    walk.to({closure, 0});
    const auto shear = [&](double s) { return walk.to({closure, s}).shear; };
    for (const double y : {0.3, 0.7, 1.0 - 1e-12}) {
        const double s = y * c.critical_sliding;
        expect_close(shear(s), c.shear_stiffness * s * std::exp(-y), 1e-12, c.cohesion);
    }
    EXPECT_FALSE(walk.history().failed());
}

TEST(ConsistentLaw, NoJumpWhereThePointOpensUnlessItsOpenStrengthIsPassed) {
    const ContactParameters c = augig_contact();
    const double tiny = 1e-12 * c.critical_opening;
    // An open point is stretched by δs/δso what a closed one is by δs/δcs: cohesion falls to the open curve, never rises.
    for (const double s : {0.01, 0.1, 0.3}) {
        const double sliding = s * c.critical_sliding;
        ContactWalk walk(consistent_law(c));
        walk.to({-tiny, 0});
        const double closed = walk.go({-tiny, sliding}, 100).shear;
        const double before = walk.fracture();
        const double open = walk.to({tiny, sliding}).shear;
        const double open_load = sliding * c.shear_stiffness / (std::numbers::e * c.open_shear_strength);
        if (open_load < 1) expect_close(open, c.shear_stiffness * sliding * std::exp(-open_load), 1e-9, closed);
        EXPECT_LE(open, closed);
        EXPECT_GT(walk.fracture(), before);
        const double again = walk.to({-tiny, sliding}).shear;
        expect_close(again, open, 1e-9, closed);                             // and back without a jump
        expect_close(walk.non_conservative(), 0, 1e-12, c.fracture_energy);  // round-off
    }
}

}  // namespace
}  // namespace graincrack
