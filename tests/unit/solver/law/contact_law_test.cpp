// The contact law point by point; paths and energies are in tests/physics.
#include "solver/law/contact_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
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

IntactResponse intact_response(const ContactLaw& law, const MovedPoint& point) {
    return contact_law::with_law(law.variant, [&](auto kind) { return decltype(kind)::intact(law, point); });
}
bool is_residual(const ContactLaw& law, const ContactHistory& history) {
    return contact_law::with_law(law.variant, [&](auto kind) { return decltype(kind)::is_residual(law, history); });
}

TEST(ContactLawTable, EveryParameterIsReadByEveryLawOrByThoseThatNameIt) {
    for (const ContactParameter& row : all_contact_parameters()) {
        const auto names_it = [&](const LawDescription& law) { return law.reads(row.value); };
        EXPECT_EQ(std::any_of(all_contact_laws().begin(), all_contact_laws().end(), names_it), !row.every_law)
            << row.quantity.name;
    }
}

TEST(ContactLawTable, LawsWithFrictionBesideCohesionCountDamage) {
    for (const LawDescription& law : all_contact_laws()) {
        const bool beside = law.variant == LawVariant::combined || law.variant == LawVariant::cohesive_frictional;
        EXPECT_EQ(law.crack_event(), beside ? CrackEvent::half_damaged : CrackEvent::failed) << law.name;
    }
}

TEST(ContactLawPoint, ThePageHasASectionForEveryLaw) {
    std::ifstream file(GRAINCRACK_SOURCE "/share/doc/laws.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const LawDescription& law : all_contact_laws()) {
        EXPECT_NE(page.find("\n## `" + std::string(law.name) + "`"), std::string::npos) << law.name;
    }
}

// The areas to the peaks: Eq 14 with δut = δct; two thirds of the rectangle under Munjiza's parabola.
TEST(ContactLawPoint, LeastFractureEnergies) {
    const ContactParameters p = augig_contact();
    const auto least = [&](LawVariant variant) { return min_fracture_energies(make_contact_law(p, variant)); };
    const double paper = p.tensile_strength * p.critical_opening * (std::numbers::e - 2);
    expect_close(paper, 1.657, 3e-4, 1.657);  // four digits, by hand
    for (const LawVariant variant : {LawVariant::literal, LawVariant::consistent}) {
        expect_close(least(variant).opening, paper, 1e-15, paper);
        EXPECT_EQ(least(variant).sliding, 0);
    }
    EXPECT_EQ(least(LawVariant::coulomb_slip).opening, 0);
    const double opening = 4.0 / 3 * p.tensile_strength * p.tensile_strength / p.normal_stiffness;
    const double sliding = 4.0 / 3 * p.cohesion * p.cohesion / p.shear_stiffness;
    expect_close(least(LawVariant::combined).opening, opening, 1e-15, opening);
    expect_close(least(LawVariant::combined).sliding, sliding, 1e-15, sliding);
}

// The shear strength of a contact that is open at zero opening is what tells the laws apart: tc, a parameter, cc.
TEST(ContactLawPoint, ShearStrengthWhileOpen) {
    ContactParameters p = augig_contact();
    const double kappa = p.shear_stiffness / p.normal_stiffness;
    EXPECT_EQ(p.open_shear_strength, p.tensile_strength * std::sqrt(kappa));
    p.open_shear_strength = 11e6;
    for (const ContactLaw& law : all_laws(p)) {
        test::ContactWalk walk(law);
        walk.go({0, 1.5 * p.critical_sliding}, 100000);
        const double strength = law.variant == LawVariant::literal ? p.tensile_strength
                                : description_of(law.variant).reads(&ContactParameters::open_shear_strength)
                                    ? p.open_shear_strength
                                    : p.cohesion;
        expect_close(walk.largest_shear(), strength, 1e-4, strength);
        EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);  // open then
    }
}

bool damages_before_peak(const ContactLaw& law) {
    return contact_law::with_law(law.variant, [](auto kind) { return decltype(kind)::damages_intact; });
}

// The branch-free response of intact points is that of `update_contact` wherever it says that it holds. It holds for points that
// stay on their side of δn = 0 short of the peak.
TEST(ContactLawPoint, IntactLawAgreesWithTheFullOne) {
    for (const ContactLaw& law : all_laws(augig_contact())) {
        SCOPED_TRACE(name_of(law.variant));
        int held = 0;
        int failed = 0;
        int damaged = 0;
        for (double opening = -3; opening < 1.3; opening += 0.17) {
            for (double sliding = -2; sliding < 2; sliding += 0.13) {
                for (const double left : {1.0, 0.7}) {
                    const double reach = opening < 0 ? law.dcs : law.dct;
                    const ContactMotion to{opening * law.dct, sliding * reach};
                    ContactHistory before;
                    before.motion = {opening < 0 ? -1e-12 : 1e-9, 0.4 * reach};
                    before.integrity = damages_before_peak(law) ? left : 1;
                    const IntactResponse r = intact_response(
                        law, {before.motion.opening, before.motion.sliding, to.opening, to.sliding, before.integrity});
                    const ContactResponse full = update_contact(law, to, before);
                    failed += full.history.failed() ? 1 : 0;
                    if (r.holds == 0) {
                        EXPECT_TRUE(full.history.failed());
                        continue;
                    }
                    ++held;
                    EXPECT_FALSE(full.history.failed());
                    // 2e-16 · some products
                    expect_close(r.normal, full.traction.normal, 1e-15, law.tc + std::abs(full.traction.normal));
                    expect_close(r.shear, full.traction.shear, 1e-15, law.cc);
                    EXPECT_EQ(r.integrity, full.history.integrity);
                    EXPECT_EQ(r.fracture, full.dissipation.fracture);
                    EXPECT_EQ(full.dissipation.friction, 0);
                    EXPECT_EQ(full.dissipation.non_conservative_work, 0);
                    damaged += r.fracture > 0 ? 1 : 0;
                }
            }
        }
        EXPECT_GT(held, 100);
        EXPECT_GT(failed, 100);
        EXPECT_EQ(damaged > 100, damages_before_peak(law));
        // Over δn = 0 only laws that are one there.
        const IntactResponse crossed = intact_response(law, {1e-12, 0, -1e-12, 0, 1});
        EXPECT_EQ(crossed.holds, law.variant == LawVariant::coulomb_slip || law.variant == LawVariant::combined ? 1 : 0);
    }
}

// The same for points of which friction is left, over random walks of laws that have such points.
TEST(ContactLawPoint, ResidualLawAgreesWithTheFullOne) {
    int residual_laws = 0;
    for (const ContactLaw& law : all_laws(augig_contact())) {
        SCOPED_TRACE(name_of(law.variant));
        ContactHistory h = broken_contact();
        residual_laws += is_residual(law, h) ? 1 : 0;
        int slid = 0;
        for (int k = 0; k < 4000 && is_residual(law, h); ++k) {
            const double phase = 0.01 * k;
            const ContactMotion to{law.dct * (std::sin(phase) - 0.7), law.dcs * std::sin(2.3 * phase)};
            const ResidualResponse r = residual_response(law, contact_law::moved_point(h, to));
            const ContactResponse full = update_contact(law, to, h);
            const bool crosses = (to.opening >= 0) != (h.motion.opening >= 0);
            EXPECT_EQ(r.holds, crosses ? 0 : 1);
            if (!crosses) {
                EXPECT_EQ(r.normal, full.traction.normal);
                EXPECT_EQ(r.shear, full.traction.shear);
                EXPECT_EQ(r.slip, full.history.slip);
                EXPECT_EQ(r.friction, full.dissipation.friction);
                EXPECT_EQ(full.dissipation.fracture, 0);
                EXPECT_EQ(full.dissipation.non_conservative_work, 0);
                EXPECT_TRUE(full.history.separated);
                slid += r.friction > 0 ? 1 : 0;
            }
            h = full.history;
        }
        EXPECT_EQ(slid > 500, is_residual(law, broken_contact()));
    }
    EXPECT_GE(residual_laws, 4);
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
