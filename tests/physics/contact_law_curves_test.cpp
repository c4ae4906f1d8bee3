// The closed forms of each contact law: curves and their areas, strengths and residuals under pressure, damage. No mesh, no
// dynamics. Numbers are those of Augig granite with tc 24.15 MPa, cc 74.57 MPa, φc 48.76° in plane strain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/gauss.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using contact_law::munjiza_softening;

constexpr double euler = std::numbers::e;
constexpr double closed_at_zero = -1e-30;  // m, on which friction is none

ContactParameters mode_i_contact() { return augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i); }
/// A point at rest under a pressure.
ContactHistory pressed(const ContactLaw& law, double pressure) { return {.motion = {-pressure / law.kt, 0}}; }
/// z as Munjiza, Andrews & White (1999) print it.
double printed_softening(double D) {
    const double a = 0.63;
    const double b = 1.8;
    const double c = 6;
    return (1 - (a + b - 1) / (a + b) * std::exp(D * (a + c * b) / ((a + b) * (1 - a - b)))) *
           (a * (1 - D) + b * std::pow(1 - D, c));
}
/// D at which z(D) is `remaining`, by bisection.
double damage_of_combined(double remaining) {
    if (remaining == 0 || remaining == 1) return 1 - remaining;  // z is flat at both ends
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (munjiza_softening(middle) > remaining ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Opening without sliding at which `remaining` is left, m: the traction falls on a line from δct to δut.
double opening_where(const ContactLaw& law, double remaining) {
    switch (law.variant) {
        case LawVariant::coulomb_slip: return law.tc / law.kt;
        case LawVariant::combined: return law.op * (1 + damage_of_combined(remaining) * law.o_range);
        default: return law.dct + (1 - remaining) * (law.dut - law.dct);
    }
}
/// Sliding of a point that is closed at zero opening at which `remaining` is left, m: in most laws it is lost at once.
double sliding_where(const ContactLaw& law, double remaining) {
    switch (law.variant) {
        case LawVariant::coulomb_slip: return law.cc / law.ks;
        case LawVariant::combined: return law.sp * (1 + damage_of_combined(remaining) * law.s_range);
        case LawVariant::cohesive_frictional: return law.dcs * (1 + (1 - remaining) * law.s_range);
        default: return law.dcs;
    }
}

// --- curves of one motion --------------------------------------------------------------------------------------------------

// Opening alone. Up to the peak Eq 7, kt δ e^(−δ/δct), or the parabola x (2 − x) of `combined`; past it 1 − D or z(D) of tc, from
// which it unloads and reloads on the secant. Tolerances: round-off, of the softening over its range.
TEST(ContactLaws, OpenAsTheirCurves) {
    for (const ContactParameters& c : {augig_contact(), weak_contact(), mode_i_contact()}) {
        for (const ContactLaw& law : all_laws(c)) {
            if (law.variant == LawVariant::coulomb_slip) continue;
            SCOPED_TRACE(name_of(law.variant));
            const bool combined = law.variant == LawVariant::combined;
            const double peak = opening_where(law, 1);
            ContactWalk walk(law);
            for (const double x : {0.1, 0.5, 0.9, 1.0}) {
                const double traction = combined ? law.tc * x * (2 - x) : law.kt * x * law.dct * std::exp(-x);
                expect_close(walk.to({x * peak, 0}).normal, traction, 1e-14, law.tc);
                EXPECT_EQ(remaining_cohesion(law, walk.history()), 1);
            }
            EXPECT_FALSE(walk.history().failed());
            EXPECT_TRUE(!combined || walk.fracture() == 0);  // elastic so far
            for (const double d : {0.1, 0.4, 0.9}) {
                const double opening = peak + d * (opening_where(law, 0) - peak);
                const double left = combined ? printed_softening(d) : 1 - d;
                expect_close(walk.to({opening, 0}).normal, left * law.tc, 1e-12, law.tc);
                const bool frictional = law.variant == LawVariant::cohesive_frictional;  // its damage is that of sliding
                expect_close(frictional ? d : damage(law, walk.history()), d, 1e-12, 1);
                expect_close(remaining_cohesion(law, walk.history()), left, 1e-12, 1);
                const double split = walk.traction().normal;
                expect_close(walk.to({0.25 * opening, 0}).normal, 0.25 * split, 1e-12, split);
                expect_close(walk.to({opening, 0}).normal, split, 1e-12, split);
            }
        }
    }
}

/// The area under a curve of one motion.
struct Area {
    std::string row;
    ContactLaw law;
    bool slides;
    double opening;  ///< of sliding, m: open or closed at zero
    double energy;   ///< J/m²
    const char* source;
};

// The area under opening is Gf (Eqs 14, 32) or G_I, that under sliding at zero opening is G_II, to the error of Gauss's rule;
// then nothing is left.
TEST(ContactLaws, TakeTheirFractureEnergies) {
    const ContactParameters c = augig_contact();
    const ContactParameters brittle = mode_i_contact();
    expect_close(brittle.fracture_energy, 82.6, 1e-3, 82.6);  // K_IC²/Ẽ, three digits
    expect_close(brittle.mode_ii_fracture_energy, 4 * brittle.fracture_energy, 1e-12, brittle.fracture_energy);  // (K_IIC/K_IC)²
    const ContactLaw combined = make_contact_law(brittle, LawVariant::combined);
    const ContactLaw weak = make_contact_law(weak_contact(), LawVariant::cohesive_frictional);
    const std::string frictional = "law: cohesive-frictional, area under sliding without pressure (J/m2)";
    std::vector<Area> areas{{"law: area under opening (J/m2)", make_contact_law(c, LawVariant::literal), false, 0,
                             c.fracture_energy, "Gf, Eqs 14, 32"},
                            {"law: combined, area under opening (J/m2)", combined, false, 0, brittle.fracture_energy, "G_I"},
                            {"law: combined, area under sliding (J/m2)", combined, true, 0, combined.g2, "G_II"},
                            {"law: combined, area under sliding (J/m2)", combined, true, closed_at_zero, combined.g2, "G_II"},
                            {"law: cohesive-frictional, area under opening (J/m2)", weak, false, 0, weak.gf, "Gf"}};
    for (const double energy : {70.0, 330.0, 1000.0}) {
        const ContactLaw law = make_contact_law(weak_contact(energy), LawVariant::cohesive_frictional);
        areas.push_back({frictional, law, true, closed_at_zero, energy, "G_II"});
    }
    for (const Area& area : areas) {
        SCOPED_TRACE(area.row);
        ContactWalk walk(area.law, {.motion = {area.opening, 0}});
        const auto traction = [&](double d) {
            const ContactTraction t = walk.to(area.slides ? ContactMotion{area.opening, d} : ContactMotion{d, 0});
            return area.slides ? t.shear : t.normal;
        };
        const auto place = area.slides ? sliding_where : opening_where;
        const double peak = place(area.law, 1);
        const double last = place(area.law, 0);
        verify(area.row, integral(traction, 0, peak, 8) + integral(traction, peak, last, 40), area.energy, 1e-9, area.source);
        expect_close(traction(1.001 * last), 0, 1e-15, area.law.cc);
        EXPECT_EQ(damage(area.law, walk.history()), 1);
    }
    verify("law: area under opening as printed (J/m2)", c.fracture_energy, 412.97965, 1e-7, "Eq 32 by hand, eight digits");
    const double before = c.tensile_strength * c.critical_opening * (euler - 2);
    verify("law: its part before the peak over Gf", before / c.fracture_energy, 0.0040, 0.0125,
           "tc dct (euler - 2)/Gf, two digits");
}

// The least energies with which the laws work are the areas to their peaks: Eq 14 with δut = δct, 1.657 J/m² by hand; two thirds
// of the rectangle under Munjiza's parabola.
TEST(ContactLaws, NeedTheEnergiesToTheirPeaks) {
    const ContactParameters p = augig_contact();
    const double paper = p.tensile_strength * p.critical_opening * (euler - 2);
    expect_close(paper, 1.657, 3e-4, 1.657);
    for (const ContactLaw& law : all_laws(p)) {
        const FractureEnergies least = min_fracture_energies(law);
        const bool combined = law.variant == LawVariant::combined;
        const double opening = combined                                  ? 4.0 / 3 * law.tc * law.tc / law.kt
                               : law.variant == LawVariant::coulomb_slip ? 0
                                                                         : paper;
        expect_close(least.opening, opening, 1e-15, paper);
        expect_close(least.sliding, combined ? 4.0 / 3 * law.cc * law.cc / law.ks : 0, 1e-15, law.g2);
    }
}

// The shear strength of a contact that is open at zero opening is what tells the laws apart: tc, a parameter (tc √κ by default),
// cc; to the steps.
TEST(ContactLaws, HaveTheirShearStrengthsWhileOpen) {
    ContactParameters p = augig_contact();
    EXPECT_EQ(p.open_shear_strength, p.tensile_strength * std::sqrt(p.shear_stiffness / p.normal_stiffness));
    p.open_shear_strength = 11e6;
    for (const ContactLaw& law : all_laws(p)) {
        ContactWalk walk(law);
        walk.go({0, 1.5 * p.critical_sliding}, 100000);
        const double strength = law.variant == LawVariant::literal ? law.tc
                                : description_of(law.variant).reads(&ContactParameters::open_shear_strength)
                                    ? p.open_shear_strength
                                    : law.cc;
        expect_close(walk.largest_shear(), strength, 1e-4, strength);
        EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);  // open then
    }
}

/// Walks in equal steps of opening (`sense` 0) or sliding and expects each damage level to be passed in the step that crosses its
/// closed form.
void expect_levels_at(const ContactLaw& law, double sense) {
    SCOPED_TRACE(name_of(law.variant));
    const auto place = sense == 0 ? opening_where : sliding_where;
    const double step = place(law, 0.1) / 9973.5;
    ContactWalk walk(law);
    std::size_t passed = 0;
    for (int k = 1; k <= 10000; ++k) {
        walk.to(sense == 0 ? ContactMotion{k * step, 0} : ContactMotion{closed_at_zero, sense * k * step});
        const std::size_t now = count_levels_above(remaining_cohesion(law, walk.history()));
        for (; passed < now; ++passed) {
            const double expected = place(law, std::array{0.9, 0.5, 0.1}[passed]);
            EXPECT_GT(k * step, expected * (1 - 1e-9));
            EXPECT_LE((k - 1) * step, expected * (1 + 1e-9));
            EXPECT_TRUE(walk.history().failed());
        }
        EXPECT_EQ(passed, now);  // nothing heals
    }
    EXPECT_EQ(passed, damage_levels.size());
}

// A point is damaged by 10, 50 and 90 % where its curve has 0.9, 0.5 and 0.1 of the peak left, to a step.
TEST(ContactLaws, PassTheirDamageLevelsWhereTheirCurvesSay) {
    for (const ContactLaw& law : all_laws(weak_contact())) {
        for (const double sense : {0.0, 1.0, -1.0}) expect_levels_at(law, sense);
    }
}

// --- shear under pressure --------------------------------------------------------------------------------------------------

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
    const ContactParameters c = augig_contact();
    const double friction = pressure * std::tan(c.friction_angle);
    return {make_contact_law(c, variant), std::max(c.cohesion, friction), friction, 4 * c.critical_sliding, "cc, Eq 10"};
}
/// Friction is mobilised while cohesion softens by z: the peak is between what is left then and the sum of both.
Sheared combined_row(double pressure) {
    const ContactParameters c = mode_i_contact();
    const ContactLaw law = make_contact_law(c, LawVariant::combined);
    const double friction = pressure * law.tan_phi;
    const double least = munjiza_softening(friction / law.ks / (law.sp * law.s_range)) * law.cc + friction;
    const double bound = (law.cc + friction) / least - 1 + 2e-4;
    return {law, least, friction, 1.1 * sliding_where(law, 0), "between z(D) cc + p tan phi and their sum", bound, law.g2};
}
/// Cohesion falls on a line while friction rises on one; the strength is where friction reaches its limit.
Sheared frictional_row(double energy, double pressure) {
    const ContactLaw law = make_contact_law(weak_contact(energy), LawVariant::cohesive_frictional);
    const double softening = 2 * (energy / law.cc - (euler - 2) * law.dcs);
    const double limit = pressure * law.tan_phi;
    return {law, law.cc * (1 - limit / law.ks / softening) + limit, limit, 1.1 * (law.dcs + softening),
            "cc (1 − Δ/(s δcs)) + p tan φc"};
}
/// tc 24.15 MPa, cc 74.57 MPa, φ 48.76°; residual 3 MPa, 10 MPa, 30°.
ContactLaw residual_slip_law() {
    ContactParameters c = augig_contact();
    c.residual_tensile_strength = 3 * MPa;
    c.residual_cohesion = 10 * MPa;
    c.residual_friction_angle = 30 * degree;
    return make_contact_law(c, LawVariant::coulomb_slip);
}
/// Both at once, and both fall at once to their residual values.
Sheared coulomb_row(double pressure) {
    const ContactLaw law = residual_slip_law();
    const double peak = law.cc + pressure * law.tan_phi;
    const double residual = 10 * MPa + pressure * std::tan(30 * degree);
    const double fall = 0.5 * (peak * peak - residual * residual) / law.ks;
    return {law, peak, residual, 3 * peak / law.ks, "c + sigma_n tan(phi)", 2e-4, fall};
}

// Slid under a pressure a point has its strength, to the steps, and then its residual; a loop at the residual dissipates traction
// times slip; opened it separates.
TEST(ContactLaws, HaveTheirStrengthsAndResidualsUnderPressure) {
    for (const double pressure : {5 * MPa, 20 * MPa, 100 * MPa}) {
        for (const Sheared& row :
             {paper_row(LawVariant::literal, pressure), paper_row(LawVariant::consistent, pressure), combined_row(pressure),
              frictional_row(70, pressure), frictional_row(1000, pressure), coulomb_row(pressure)}) {
            const std::string name = "law: " + std::string(name_of(row.law.variant)) + ", shear under pressure, ";
            SCOPED_TRACE(name);
            const double closure = -pressure / row.law.kt;
            ContactWalk walk(row.law);
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
            expect_close(walk.traction().shear, -row.residual, 1e-9, row.residual);
            walk.go({closure, row.far}, 20000);
            const double slip = 2 * (2 * row.far - 2 * row.residual / row.law.ks);
            EXPECT_GT(slip, 0);
            verify(name + "loop at the residual, dissipation (J/m2)", walk.friction() - friction, row.residual * slip, 1e-5,
                   "traction times slip");
            expect_close(walk.work() - work, walk.friction() - friction, 1e-5, row.residual * slip);
            walk.go({0.2 * row.law.dct, row.far}, 2000);
            EXPECT_EQ(walk.traction().normal, 0);
            EXPECT_EQ(point_state(walk.history()), PointState::separated);
            EXPECT_EQ(damage(row.law, walk.history()), 1);
        }
    }
}

// Up to the peak Eq 10 at any pressure, ks δ e^(−δ/δcs), whose area is cc δcs (e − 2); the peak is cc, whatever the pressure.
TEST(ContactLaws, OfThePaperSlideAsEq10) {
    const ContactParameters c = augig_contact();
    verify("law: critical sliding (mm)", c.critical_sliding / mm, 2.9025e-3, 2e-5, "Eq 11, five digits");
    for (const LawVariant variant : {LawVariant::literal, LawVariant::consistent}) {
        const ContactLaw law = make_contact_law(c, variant);
        for (const double pressure : {1 * MPa, 20 * MPa, 100 * MPa}) {
            ContactWalk walk(law);
            walk.to({-pressure / law.kt, 0});
            const auto shear = [&](double s) {
                const ContactTraction t = walk.to({-pressure / law.kt, s});
                expect_close(t.normal, -pressure, 1e-14, pressure);
                expect_close(t.shear, law.ks * s * std::exp(-s / law.dcs), 1e-12, law.cc);
                return t.shear;
            };
            const double energy = integral(shear, 0, law.dcs, 8);
            verify("law: shear to its peak under pressure (J/m2)", energy, 155.46, 5e-5, "cc dcs (euler - 2), five digits");
            expect_close(energy, law.cc * law.dcs * (euler - 2), 1e-12, energy);
            verify("law: shear peak at any pressure (MPa)", shear(law.dcs * (1 - 1e-12)) / MPa, law.cc / MPa, 1e-11, "cc, Eq 10");
            EXPECT_LE(walk.largest_shear(), law.cc * (1 + 1e-14));
            EXPECT_FALSE(walk.history().failed());
            walk.to({-pressure / law.kt, law.dcs * (1 + 1e-12)});
            EXPECT_TRUE(walk.history().failed_closed);
        }
    }
}

// --- what one law has of its own -------------------------------------------------------------------------------------------

// At δn = 0 an intact contact that carries shear goes from Eq 10 to Eqs 7 and 13: τ jumps from ks δs e^(−δs/δcs) up to
// kt δs e^(−δs/δct), by nearly kt/ks = 9.8, and a loop (slide closed, open, slide back, close) makes the difference of their
// energies. Trapezia of 4000 steps are off by less than 1e-7.
TEST(LiteralLaw, JumpsWhereItOpensBeforeDamage) {
    const ContactLaw law = make_contact_law(augig_contact(), LawVariant::literal);
    const double s = 0.5 * law.dct;
    const auto energy = [](double k, double d, double peak) {  // of Eq 7 or 10
        return k * peak * peak * (1 - (1 + d / peak) * std::exp(-d / peak));
    };
    const double closed = law.ks * s * std::exp(-s / law.dcs);
    const double open = law.kt * s * std::exp(-s / law.dct);
    const double scale = energy(law.ks, s, law.dcs);
    const double made = energy(law.kt, s, law.dct) - scale;
    const double tiny = 1e-12 * law.dct;
    ContactWalk walk(law);
    walk.to({-tiny, 0});
    expect_close(walk.go({-tiny, s}, 4000).shear, closed, 1e-10, closed);
    verify("law: shear on opening over that before, literal", walk.to({tiny, s}).shear / closed, open / closed, 1e-10,
           "the variant's branches at opening 0");
    walk.go({tiny, 0}, 4000);
    walk.to({-tiny, 0});
    EXPECT_FALSE(walk.history().failed());
    expect_close(walk.work(), -made, 1e-6, scale);
    expect_close(walk.non_conservative(), -made, 1e-6, scale);
    EXPECT_EQ(walk.fracture() + walk.friction(), 0);
    EXPECT_GT(made, 2 * scale);
}

// In every direction of opening the area is Gf = q/λ² [(1 − 2/e) + (λu − 1)/(2 e)], which gives λu, where no strength is left
// (solver/law/cohesive_damage.hpp); to the error of Gauss's rule, and of trapezia in steps.
TEST(ConsistentLaw, TakesItsFractureEnergyInEveryDirection) {
    for (const ContactParameters& c : {augig_contact(), mode_i_contact()}) {
        const ContactLaw law = make_contact_law(c, LawVariant::consistent);
        for (const double degrees : {0.0, 20.0, 45.0, 70.0, 89.0}) {
            const double n = std::cos(degrees * degree);
            const double t = std::sin(degrees * degree);
            ContactWalk walk(law);
            const auto along = [&](double reach) {
                const ContactTraction traction = walk.to({reach * n, reach * t});
                return n * traction.normal + t * traction.shear;
            };
            const double peak = 1 / std::hypot(n * law.inv_dct, t * law.inv_dso);
            const double form = (law.kt * n * n + law.ks * t * t) * peak * peak;
            const double last = peak * (1 + 2 * euler * (law.gf / form - (1 - 2 / euler)));
            verify("law: consistent, area under opening in five directions (J/m2)",
                   integral(along, 0, peak, 8) + integral(along, peak, last, 8), law.gf, 1e-9, "Gf, Eq 32");
            EXPECT_EQ(along(1.001 * last), 0);
            EXPECT_TRUE(walk.history().separated);
            ContactWalk steps(law);
            steps.go({1.001 * last * n, 1.001 * last * t}, 20000);
            expect_close(steps.fracture(), law.gf, 1e-4, law.gf);
        }
    }
}

// z(D) is that of Munjiza, Andrews & White (1999), falls steadily from 1 to 0 and has the area of combined.hpp, to round-off.
TEST(CombinedLaw, SoftensAsMunjizaHasIt) {
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

// Where the largest opening and sliding are the present ones, the tractions are z of the joint D = √(Dn² + Ds²), to round-off.
// Closed after opening a point has friction from zero, on all of the area, beside the cohesion that is left.
TEST(CombinedLaw, CouplesItsModes) {
    const ContactLaw law = make_contact_law(mode_i_contact(), LawVariant::combined);
    for (const double share : {0.1, 0.3, 0.6}) {
        ContactWalk walk(law);
        walk.go({law.op * (1 + share * law.o_range), -law.sp * (1 + 0.5 * law.s_range)}, 100);
        const double z = printed_softening(std::sqrt(share * share + 0.25));
        const std::string name = "law: combined, tractions under both modes over strength";
        verify(name, walk.traction().normal / law.tc, z, 1e-12, "z(D)", 1);
        verify(name, walk.traction().shear / law.cc, -z, 1e-12, "z(D)", 1);
        EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);
    }
    ContactWalk walk(law);
    walk.go({law.op * (1 + 0.5 * law.o_range), 0}, 1000);
    const double closure = -20 * MPa / law.kt;
    walk.go({closure, 0}, 1000);
    walk.go({closure, 0.5 * law.sp}, 1000);
    expect_close(walk.traction().shear, printed_softening(0.5) * law.cc * 0.75 + 20 * MPa * law.tan_phi, 1e-12, law.cc);
}

// With a residual friction angle friction weakens as cohesion does: τ = cc (1 − D) + p [(1 − D) tan φc + D tan φr], to the steps.
// The work is what was booked, less the energy of the pressure at the start; trapezia are off by 5.5e-7.
TEST(CohesiveFrictionalLaw, WeakensItsFrictionWithCohesion) {
    ContactParameters c = weak_contact();
    c.residual_friction_angle = 30 * degree;
    const ContactLaw law = make_contact_law(c, LawVariant::cohesive_frictional);
    const double pressure = 20 * MPa;
    ContactWalk walk(law, pressed(law, pressure));
    const double opening = walk.history().motion.opening;
    for (const double lost : {0.3, 0.6, 0.9}) {
        const double tan_phi = (1 - lost) * law.tan_phi + lost * std::tan(30 * degree);
        verify("law: cohesive-frictional, traction while friction weakens (MPa)",
               walk.go({opening, sliding_where(law, 1 - lost)}, 2000).shear / MPa,
               (law.cc * (1 - lost) + pressure * tan_phi) / MPa, 1e-9, "both in proportion to 1 − D");
        expect_close(damage(law, walk.history()), lost, 1e-9, 1);
    }
    walk.go({opening, 2 * sliding_where(law, 0)}, 20000);
    expect_close(walk.traction().shear, pressure * std::tan(30 * degree), 1e-12, pressure);
    EXPECT_TRUE(contact_law::CohesiveFrictional::is_residual(law, walk.history()));
    EXPECT_GE(walk.min_friction(), 0);
    expect_close(walk.balance(), -0.5 * pressure * pressure / law.kt, 1e-6, walk.work());
}

// Below the energy to the peak, (e − 2) cc δcs, nothing softens: under pressure the law is `consistent`.
TEST(CohesiveFrictionalLaw, IsConsistentWhereItsEnergyIsSmall) {
    const double least = (euler - 2) * weak_contact().cohesion * weak_contact().critical_sliding;
    EXPECT_TRUE(make_contact_law(weak_contact(1.1 * least), LawVariant::cohesive_frictional).softens_in_shear);
    const ContactParameters c = weak_contact(0.9 * least);
    const ContactLaw law = make_contact_law(c, LawVariant::cohesive_frictional);
    EXPECT_FALSE(law.softens_in_shear);
    for (const double pressure : {5.0, 50.0}) {
        ContactWalk here(law, pressed(law, pressure * MPa));
        ContactWalk there(make_contact_law(c, LawVariant::consistent), pressed(law, pressure * MPa));
        for (int k = 1; k < 400; ++k) {
            const ContactMotion to{here.history().motion.opening, 3 * c.critical_sliding * std::sin(0.02 * k)};
            EXPECT_EQ(here.to(to).shear, there.to(to).shear);
        }
        EXPECT_TRUE(here.history().failed());
        expect_close(here.fracture(), there.fracture(), 1e-12, there.fracture());
        expect_close(here.friction(), there.friction(), 1e-12, there.friction());
    }
}

// Tension is linear up to tc and then gone for good, with the energy ½ tc²/kt; intact, also over δn = 0, work is stored to
// round-off.
TEST(CoulombSlipLaw, IsLinearInTensionAndThenGone) {
    const ContactLaw law = make_contact_law(augig_contact(), LawVariant::coulomb_slip);
    const double peak = law.tc / law.kt;
    ContactWalk walk(law);
    walk.go({peak * (1 - 1e-9), 0}, 10);
    verify("law: coulomb-slip, tensile strength (MPa)", walk.traction().normal / MPa, 24.15, 1e-8, "tc");
    walk.to({peak * (1 + 1e-9), 0});
    EXPECT_EQ(walk.traction().normal, 0);
    EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);
    EXPECT_EQ(point_state(walk.history()), PointState::separated);
    expect_close(walk.fracture(), 0.5 * law.tc * peak, 1e-8, walk.fracture());
    std::mt19937_64 generator(7);
    const auto next = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; };  // in (−1, 1)
    for (int i = 0; i < 24; ++i) {
        ContactWalk intact(law);
        double largest = 0;
        for (int k = 0; k < 12; ++k) {
            const double opening = 0.9 * peak * next();
            intact.go({opening, 0.6 * law.cc / law.ks * next()}, 3);
            largest = std::max(largest, intact.stored());
        }
        EXPECT_FALSE(intact.history().failed());
        expect_close(intact.balance(), 0, 1e-13, largest);
    }
}

// Beyond its maximum closure Vm a joint is as stiff as a boundary of the rock, σn = kt Vm + k (closure − Vm), to round-off;
// opened again it is soft. Other laws have no joints.
TEST(CoulombSlipLaw, ShutsAJointAtItsMaximumClosure) {
    ContactParameters c = augig_contact();
    c.maximum_closure = 2e-6;
    c.shut_stiffness = 50 * c.normal_stiffness;
    const ContactLaw law = make_contact_law(c, LawVariant::coulomb_slip);
    ContactWalk walk(law);
    for (const double closure : {1e-6, 2e-6, 5e-6, 1.5e-6}) {
        walk.go({-closure, 0}, 10);
        const double soft = std::min(closure, 2e-6);
        const double beyond = closure - soft;
        verify("law: coulomb-slip, traction of a joint that shuts (MPa)", -walk.traction().normal / MPa,
               law.kt * (soft + 50 * beyond) / MPa, 1e-12, "kt Vm + k (closure - Vm)");
        const double energy = law.kt * (0.5 * soft * soft + beyond * (2e-6 + 25 * beyond));
        expect_close(walk.stored(), energy, 1e-12, energy);
    }
    EXPECT_EQ(law.stiffest_normal, 50 * law.kt);
    EXPECT_EQ(make_contact_law(c, LawVariant::consistent).stiffest_normal, law.kt);
}

// Open, the Coulomb line continues into tension: 74.57 − 20 tan 48.76° = 51.7561 MPa under 20 MPa, by hand, to 1e-5 of sliding.
TEST(CoulombSlipLaw, LosesShearStrengthUnderTension) {
    const ContactLaw law = make_contact_law(augig_contact(), LawVariant::coulomb_slip);
    const double opening = 20 * MPa / law.kt;
    const double strength = 51.7561 * MPa;
    ContactWalk walk(law);
    walk.go({opening, 0}, 10);
    walk.go({opening, strength / law.ks * (1 - 1e-5)}, 10);
    EXPECT_FALSE(walk.history().failed());
    verify("law: coulomb-slip, shear strength at 20 MPa of tension (MPa)", walk.largest_shear() / MPa, strength / MPa, 2e-5,
           "c - sigma_n tan(phi) by hand");
    const double stored = walk.stored();
    walk.to({opening, strength / law.ks * (1 + 1e-5)});
    EXPECT_EQ(walk.traction().normal, 0);  // above the residual tension of nothing: separated
    EXPECT_EQ(walk.traction().shear, 0);
    EXPECT_EQ(walk.history().first_mode, CrackMode::tensile);  // by the files' convention: it was open
    expect_close(walk.fracture(), stored, 5e-5, stored);
}

// Failed in shear, then opened: the residual tension 3 MPa is borne once, shear on the residual strength 10 − 3 tan 30° MPa
// relaxes as friction, to the steps. Closed again it slips at its residual cohesion, which is none that it could lose; opened
// again it pulls no more.
TEST(CoulombSlipLaw, BearsItsResidualTensionOnce) {
    const ContactLaw law = residual_slip_law();
    const double closure = -20 * MPa / law.kt;
    ContactWalk walk(law);
    walk.to({closure, 0});
    walk.go({closure, 3e-6}, 2000);
    ASSERT_TRUE(walk.history().failed_closed);
    EXPECT_EQ(remaining_cohesion(law, walk.history()), 0);
    const double opening = 3 * MPa / law.kt;
    walk.go({opening * (1 - 1e-9), 3e-6}, 4000);
    verify("law: coulomb-slip, residual tensile strength (MPa)", walk.traction().normal / MPa, 3, 1e-8, "as given");
    const double limit = 10 * MPa - 3 * MPa * std::tan(30 * degree);
    expect_close(walk.traction().shear, limit, 1e-6, limit);
    EXPECT_FALSE(walk.history().separated);
    const double fracture = walk.fracture();
    const double friction = walk.friction();
    const double stored = walk.stored();
    walk.to({opening * (1 + 1e-9), 3e-6});
    EXPECT_TRUE(walk.history().separated);
    EXPECT_EQ(walk.traction().shear, 0);
    expect_close(walk.fracture() - fracture, 0.5 * 3 * MPa * opening, 1e-8, stored);
    expect_close(walk.friction() - friction, 0.5 * limit * limit / law.ks, 1e-6, stored);
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
}  // namespace graincrack::test
