// Bridges of the laws that have them: the curve of opening and its area, every direction, closing, tearing, marks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/gauss.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

/// Brittle contacts, 5 J/m² and 7.5 MPa, whose bridges hold `share` of the strength over 80 J/m².
ContactParameters bridged_contact(double share) {
    Material material = augig_granite();
    material.contact.tensile_strength = 7.5 * MPa;
    material.contact.cohesion = 50 * MPa;
    material.contact.fracture_energy = 5;
    material.contact.mode_ii_fracture_energy = 400;
    material.contact.open_shear_strength = 7.5 * MPa;
    material.contact.bridging_strength = share * 7.5 * MPa;
    material.contact.bridging_energy = 80;
    return contact_parameters(material, PlaneCondition::strain, std::nullopt);
}
constexpr LawVariant bridged_laws[] = {LawVariant::consistent, LawVariant::cohesive_frictional};
double last_bridged_opening(const ContactParameters& c) { return 2 * c.bridging_energy / c.bridging_strength; }
/// tc (1 − D) of the brittle part past its peak.
double brittle(const ContactParameters& c, double opening) {
    return c.tensile_strength * std::max(0.0, 1 - (opening - c.critical_opening) / (c.ultimate_opening - c.critical_opening));
}
double bridge(const ContactParameters& c, double opening) {
    return c.bridging_strength * std::max(0.0, 1 - opening / last_bridged_opening(c));
}

// The traction of opening is the higher of the brittle line and the bridge's, σb (1 − δ/δb), δb = 2 Gb/σb, to round-off; its
// energy both areas less the common one, to trapezia.
TEST(Bridge, FollowsTheHigherOfTwoLines) {
    for (const double share : {0.2, 0.45, 0.65}) {
        const ContactParameters c = bridged_contact(share);
        for (const LawVariant variant : bridged_laws) {
            SCOPED_TRACE(name_of(variant));
            ContactWalk walk(make_contact_law(c, variant));
            walk.go({c.critical_opening, 0}, 1000);
            for (int k = 1; k < 2000; ++k) {
                const double opening = c.critical_opening + k / 2000. * (last_bridged_opening(c) - c.critical_opening);
                expect_close(walk.to({opening, 0}).normal, std::max(brittle(c, opening), bridge(c, opening)), 1e-12,
                             c.tensile_strength);
                EXPECT_NE(point_state(walk.history()), PointState::separated);
            }
            EXPECT_EQ(walk.to({1.001 * last_bridged_opening(c), 0}).normal, 0);
            EXPECT_EQ(point_state(walk.history()), PointState::separated);
            // Both areas less the one below both lines. The way to the peak, where the first line is a curve, counts as it is.
            const double slope = c.tensile_strength / (c.ultimate_opening - c.critical_opening);
            const double end = last_bridged_opening(c);
            const double meet = (slope * c.ultimate_opening - c.bridging_strength) / (slope - c.bridging_strength / end);
            const double area = (std::numbers::e - 2) * c.tensile_strength * c.critical_opening +
                                0.5 * (c.tensile_strength + bridge(c, meet)) * (meet - c.critical_opening) +
                                0.5 * bridge(c, meet) * (end - meet);
            ContactWalk fine(make_contact_law(c, variant));
            fine.go({c.ultimate_opening, 0}, 20000);
            fine.go({1.001 * end, 0}, 20000);
            verify("law: bridges, energy of opening (J/m2), " + std::string(name_of(variant)), fine.fracture(), area, 2e-6,
                   "both areas less the common one");  // trapezia
            EXPECT_GE(fine.min_fracture(), -1e-15 * area);
        }
    }
}

// The line ends where its triangle has the energy Gb, in every direction of opening: of its length 0.7 is left at 0.3, to
// trapezia.
TEST(Bridge, HasItsEnergyInEveryDirection) {
    const ContactParameters c = bridged_contact(0.45);
    const double ratio = std::sqrt(c.normal_stiffness / c.shear_stiffness);
    for (const LawVariant variant : bridged_laws) {
        const ContactLaw law = make_contact_law(c, variant);
        for (const double direction : {0.0, 0.3, 0.7}) {  // so that q = kt d²
            const double x = std::cos(direction);
            const double y = std::sin(direction) * ratio;
            const double load = std::hypot(x * law.inv_dct, y * law.inv_dso);
            const double last = 2 * std::numbers::e * c.bridging_energy * load / (law.bridge * law.kt);
            ContactWalk walk(law);
            walk.go({0.3 * last * x, 0.3 * last * y}, 40000);
            const double before = walk.fracture();
            walk.go({1.01 * last * x, 1.01 * last * y}, 4000);
            verify("law: bridges, energy left at 0.3 of the last opening (J/m2), " + std::string(name_of(variant)),
                   walk.fracture() - before, 0.7 * c.bridging_energy, 2e-7, "0.7 Gb in any direction");  // trapezia
            EXPECT_EQ(walk.history().bridge, 0);
        }
    }
}

// Closed, a point has the shear of friction alone; opened again the bridge pulls as before, unstrained in shear. The energy
// balance closes to the steps.
TEST(Bridge, BearsNothingWhileClosedAndPullsAgain) {
    const ContactParameters c = bridged_contact(0.45);
    for (const LawVariant variant : bridged_laws) {
        SCOPED_TRACE(name_of(variant));
        const ContactLaw law = make_contact_law(c, variant);
        ContactWalk walk(law);
        const double opened = 0.5 * last_bridged_opening(c);
        const double shear = 0.02 * opened;
        walk.go({opened, 0}, 40000);
        const double normal = walk.go({opened, shear}, 100).normal;
        const double pressure = 10 * MPa;
        const double before = walk.fracture();
        walk.go({-pressure / law.kt, shear}, 4000);
        EXPECT_EQ(walk.traction().shear, 0);
        EXPECT_GT(walk.fracture(), before);  // the shear of the bridge
        walk.go({-pressure / law.kt, 2 * shear}, 1000);
        EXPECT_LE(walk.traction().shear, pressure * law.residual_tan_phi * (1 + 1e-12));
        const ContactTraction again = walk.go({opened, 2 * shear}, 4000);
        expect_close(again.normal, normal, 1e-9, normal);
        expect_close(again.shear, 0, 1e-3, normal * law.ks / law.kt);  // unstrained where it opened again
        EXPECT_EQ(walk.non_conservative(), 0);
        expect_close(walk.balance(), 0, 1e-4, walk.fracture() + walk.friction());
        // What tears it while open tears it while closed; then nothing but friction is left, and it separates.
        walk.go({-pressure / law.kt, 2 * last_bridged_opening(c) * c.tensile_strength / c.open_shear_strength}, 4000);
        EXPECT_EQ(walk.history().bridge, 0);
        walk.go({opened, 0}, 10);
        EXPECT_EQ(point_state(walk.history()), PointState::separated);
    }
}

// A point that lost its cohesion under pressure has no bridge: it begins only where a boundary is pulled apart.
TEST(Bridge, IsNoneOfAPointThatFailedClosed) {
    const ContactParameters c = bridged_contact(0.45);
    for (const LawVariant variant : bridged_laws) {
        const ContactLaw law = make_contact_law(c, variant);
        ContactWalk walk(law);
        walk.go({-5 * MPa / law.kt, 0}, 2);
        walk.go({-5 * MPa / law.kt, 3 * (c.critical_sliding + 2 * c.mode_ii_fracture_energy / c.cohesion)}, 20000);
        EXPECT_EQ(walk.history().integrity, 0);
        EXPECT_EQ(walk.to({1e-6, 0}).normal, 0);
    }
}

// 10 and 50 % are lost where the brittle part has lost them, 90 % where the bridge has.
TEST(Bridge, CountsForTheLastDamageLevelAlone) {
    for (const double share : {0.45, 0.65}) {
        const ContactParameters c = bridged_contact(share);
        for (const LawVariant variant : bridged_laws) {
            SCOPED_TRACE(name_of(variant));
            const ContactLaw law = make_contact_law(c, variant);
            const auto level = [&](double opening) {
                ContactWalk walk(law);
                walk.go({opening, 0}, 200);
                return count_levels_above(remaining_cohesion(law, walk.history()));
            };
            const double range = c.ultimate_opening - c.critical_opening;
            const double broken = last_bridged_opening(c) * (1 - 0.1 / share);
            for (const auto& [lost, levels] : {std::pair(0.099, 0U), {0.101, 1U}, {0.499, 1U}, {0.501, 2U}}) {
                EXPECT_EQ(level(c.critical_opening + lost * range), levels);
            }
            EXPECT_EQ(level(0.999 * broken), 2U);
            EXPECT_EQ(level(1.001 * broken), 3U);
        }
    }
}

}  // namespace
}  // namespace graincrack::test
