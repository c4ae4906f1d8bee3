// The contact laws on random paths: what must hold for every law whatever the motion. A new law is tested here as soon as it
// stands in the table of laws.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_contact;
using test::ContactWalk;
using test::every_law;
using test::expect_close;
using test::verify;
using test::verify_between;

constexpr int n_paths = 24;
using Path = std::vector<ContactMotion>;

/// A number in (−1, 1) that is the same everywhere.
double next(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; }

/// Twelve corners: openings within ±2 δct, every third up to half of δut; sliding within ±2 δcs.
Path random_path(const ContactParameters& c, unsigned seed) {
    std::mt19937_64 generator(seed);
    Path path;
    for (int i = 0; i < 12; ++i) {
        const double reach = i % 3 == 2 ? 0.5 * c.ultimate_opening : 2 * c.critical_opening;
        const double opening = reach * next(generator);
        // not closed by more than 200 MPa
        path.push_back({std::max(opening, -200e6 / c.normal_stiffness), 2 * c.critical_sliding * next(generator)});
    }
    return path;
}
/// The same, open or closed all the time.
Path one_sided_path(const ContactParameters& c, unsigned seed, double side) {
    Path path = random_path(c, seed);
    for (ContactMotion& m : path) m.opening = side * (std::abs(m.opening) + 1e-3 * c.critical_opening);
    return path;
}

ContactWalk led_along(const ContactLaw& law, const Path& path, int steps, double mirror = 1, const ContactHistory& start = {}) {
    ContactWalk walk(law, start);
    for (const ContactMotion& corner : path) walk.go({corner.opening, mirror * corner.sliding}, steps);
    return walk;
}
/// Sum over paths of |work − stored − booked|, for steps that halve from one to the next.
std::array<double, 4> balances(const ContactLaw& law, const std::vector<Path>& paths, double& booked) {
    std::array<double, 4> error{};
    booked = 0;
    for (const Path& path : paths) {
        int steps = 250;
        for (double& sum : error) {
            const ContactWalk walk = led_along(law, path, steps);
            sum += std::abs(walk.balance());
            booked += (walk.fracture() + walk.friction()) / static_cast<double>(error.size());
            steps *= 2;
        }
    }
    return error;
}

TEST(ContactLawPaths, DissipationIsNeverNegativeAndNothingHeals) {
    for (const auto kind : {FractureEnergyChoice::Kind::mixed, FractureEnergyChoice::Kind::mode_i}) {
        const ContactParameters c = augig_contact(PlaneCondition::strain, kind);
        for (const ContactLaw& law : every_law(c)) {
            SCOPED_TRACE(name_of(law.variant));
            int failed = 0;
            for (unsigned seed = 0; seed < n_paths; ++seed) {
                for (const int steps : {40, 500}) {  // the coarser of up to a tenth of δcs
                    const ContactWalk walk = led_along(law, random_path(c, seed), steps);
                    verify_between("law: random paths, least fracture dissipation of an update over Gf",
                                   walk.min_fracture() / c.fracture_energy, -1e-12, HUGE_VAL, "never negative");
                    verify_between("law: random paths, least friction of an update over Gf",
                                   walk.min_friction() / c.fracture_energy, 0, HUGE_VAL, "never negative");
                    EXPECT_GE(walk.stored(), 0);
                    EXPECT_FALSE(walk.healed());
                    failed += walk.history().failed() ? 1 : 0;
                }
            }
            EXPECT_GT(failed, n_paths);  // of twice as many, or nothing was tried
        }
    }
}

// Work = stored + fracture + friction + non-conservative work, up to an error that halves with the step: tractions jump where a
// peak is passed and where branches meet, and a trapezium over a jump is wrong by half of it times the step.
TEST(ContactLawPaths, WorkIsWhatWasBookedToTheStep) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        std::vector<Path> paths;
        for (unsigned seed = 0; seed < n_paths; ++seed) paths.push_back(random_path(c, seed));
        double booked = 0;
        const auto error = balances(law, paths, booked);
        EXPECT_GT(booked, n_paths * 0.1 * c.fracture_energy);
        verify("law: random paths, work less what was booked over that", error.back(), 0, 2e-4, "0 but for jumps within a step",
               booked);
        EXPECT_LT(error.back(), error.front() / 4);  // 1/8 but for the luck of where the jumps fall in a step
    }
}

// The same without jumps: opened and slid only, in the laws that soften. The error falls with the square of the step: 1/64, but
// that the last step of a path may end anywhere in it.
TEST(ContactLawPaths, WorkIsWhatWasBookedToSecondOrderWhereTractionsDoNotJump) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : every_law(c)) {
        if (law.variant == LawVariant::coulomb_slip) {
            continue;  // it falls
        }
        SCOPED_TRACE(name_of(law.variant));
        std::vector<Path> paths;
        for (unsigned seed = 0; seed < n_paths; ++seed) paths.push_back(one_sided_path(c, seed, 1));
        double booked = 0;
        const auto error = balances(law, paths, booked);
        EXPECT_GT(booked, n_paths * 0.1 * c.fracture_energy);
        verify_between("law: open random paths, error of the energy at an eighth of the step over that of the whole, " +
                           std::string(name_of(law.variant)),
                       error.back() / error.front(), 0, 1.0 / 32, "1/64: second order");
    }
}

// Where a law is linear nothing is left over but round-off: friction of a broken contact, and coulomb-slip while it is intact.
TEST(ContactLawPaths, WorkIsWhatWasBookedExactlyWhereALawIsPiecewiseLinear) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            const ContactWalk rubbed = led_along(law, one_sided_path(c, seed, -1), 500, 1, broken_contact());
            EXPECT_GT(rubbed.friction(), 0);
            verify("law: broken and closed, work less what was booked over that", rubbed.balance(), 0, 1e-12,
                   "piecewise linear: trapezia are exact", rubbed.friction());
        }
    }
    const ContactLaw slip = make_contact_law(c, LawVariant::coulomb_slip);
    std::mt19937_64 generator(7);
    for (int i = 0; i < n_paths; ++i) {
        ContactWalk walk(slip);
        double largest = 0;
        for (int k = 0; k < 12; ++k) {
            walk.go({0.9 * c.tensile_strength / slip.kt * next(generator), 0.6 * c.cohesion / slip.ks * next(generator)}, 3);
            largest = std::max(largest, walk.stored());
        }
        EXPECT_FALSE(walk.history().failed());
        expect_close(walk.balance(), 0, 1e-13, largest);  // over δn = 0 too
    }
}

// A step that turns from slip to slip the other way while the limit falls: the trapezium is negative there, nothing is booked
// (solver/law/friction.hpp), and what is missing is no more than ½ τ |Δδs|. In all other steps friction is the trapezium.
TEST(ContactLawPaths, FrictionIsTheTrapeziumOrNothing) {
    const ContactParameters c = augig_contact();
    std::mt19937_64 generator(3);
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        ContactHistory h = broken_contact();
        h.motion.opening = -1e-12;
        int turned = 0;
        int slipped = 0;
        for (int i = 0; i < 2000; ++i) {
            const ContactMotion to{-1e-7 * (1.01 + next(generator)), c.critical_sliding * next(generator)};
            const ContactResponse r = update_contact(law, to, h);
            const double before = law.ks * (h.motion.sliding - h.slip);
            const double after = r.traction.shear;
            const double moved = to.sliding - h.motion.sliding;
            const double wanted = 0.5 * (before + after) * moved - 0.5 * (after * after - before * before) / law.ks;
            // round-off: of tractions ks (δs − slip), and of the two squares
            const double scale = law.ks * c.critical_sliding * std::abs(moved) + (after * after + before * before) / law.ks;
            if (wanted < -1e-14 * scale) {
                EXPECT_EQ(r.dissipation.friction, 0);
                EXPECT_GE(wanted, -0.5 * std::abs(before * moved));
                EXPECT_LT(before * after, 0);                  // it turned
                EXPECT_LT(std::abs(after), std::abs(before));  // under a falling limit
                ++turned;
            } else {
                expect_close(r.dissipation.friction, wanted, 1e-14, scale);
                ++slipped;
            }
            h = r.history;
        }
        EXPECT_GT(turned, 100);
        EXPECT_GT(slipped, 100);
    }
}

TEST(ContactLawPaths, MirrorSymmetryInSliding) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            const ContactWalk walk = led_along(law, random_path(c, seed), 200);
            const ContactWalk mirrored = led_along(law, random_path(c, seed), 200, -1);
            EXPECT_EQ(walk.traction().normal, mirrored.traction().normal);
            verify("law: shear of the mirrored path over tc", -mirrored.traction().shear, walk.traction().shear, 0x1p-60,
                   "the same, to the bit", law.tc);
            EXPECT_EQ(walk.fracture(), mirrored.fracture());
            EXPECT_EQ(walk.friction(), mirrored.friction());
            EXPECT_EQ(walk.non_conservative(), mirrored.non_conservative());
            EXPECT_EQ(walk.history().failed_open, mirrored.history().failed_open);
        }
    }
}

// Where a law has a potential, nothing may be left over: closed paths, and opening without sliding; in laws that say they have
// one everywhere, any path.
TEST(ContactLawPaths, NoNonConservativeWorkWhereThereIsAPotential) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        double others = 0;
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            Path opening = random_path(c, seed);
            for (ContactMotion& m : opening) m = {std::abs(m.opening), 0};
            const Path closed = one_sided_path(c, seed, -1);
            ContactHistory start;
            start.motion.opening = -1e-30;  // closed from the first step on
            const ContactWalk pushed = led_along(law, closed, 200, 1, start);
            EXPECT_EQ(pushed.non_conservative(), 0);
            EXPECT_GT(pushed.work(), 0);
            const ContactWalk pulled = led_along(law, opening, 200);
            expect_close(pulled.non_conservative(), 0, 1e-12, c.fracture_energy);
            EXPECT_GT(pulled.fracture(), 0);
            others = std::max(others, std::abs(led_along(law, random_path(c, seed), 200).non_conservative()));
        }
        if (description_of(law.variant).potential) {
            verify("law: random paths, non-conservative work over Gf, " + std::string(name_of(law.variant)), others, 0, 1e-12,
                   "it has a potential", c.fracture_energy);
        } else {
            EXPECT_GT(others, 1e-6 * c.fracture_energy);  // elsewhere these have some
        }
    }
}

// With its history fixed the traction is the gradient of the stored energy, in any state.
TEST(ContactLawPaths, TractionIsTheGradientOfTheStoredEnergy) {
    const ContactParameters c = augig_contact();
    const double d = 1e-5 * c.critical_opening;
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        int open = 0;
        int closed = 0;
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            ContactWalk walk(law);
            for (const ContactMotion& corner : random_path(c, seed)) {
                walk.go(corner, 50);
                const ContactHistory& h = walk.history();
                if (std::abs(corner.opening) < 2 * d) continue;
                const auto energy = [&](double opening, double sliding) {
                    ContactHistory at = h;
                    at.motion = {opening, sliding};
                    return stored_energy(law, at);
                };
                const auto [o, s] = corner;
                const double normal = (energy(o + d, s) - energy(o - d, s)) / (2 * d);
                const double shear = (energy(o, s + d) - energy(o, s - d)) / (2 * d);
                // d²/6 of the third derivative, and round-off of energies of up to 200 MPa · δcs: 1e-16 · 300 J/m² / d
                const std::string name(name_of(law.variant));
                verify("law: traction less the slope of the energy over tc, " + name, walk.traction().normal, normal, 2e-8,
                       "central differences", law.tc);
                verify("law: traction less the slope of the energy over tc, " + name, walk.traction().shear, shear, 2e-8,
                       "central differences", law.tc);
                (o > 0 ? open : closed) += 1;
            }
        }
        EXPECT_GT(open, 50);
        EXPECT_GT(closed, 50);
    }
}

// The tangent against differences: kt and ks at rest, and nowhere more than the stable time step was made for.
TEST(ContactLawPaths, NoTangentIsStifferThanTheTimeStepKnows) {
    const ContactParameters c = augig_contact();
    const double d = 1e-6 * c.critical_opening;
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        ContactHistory rest;
        rest.motion.opening = -1e-30;
        const auto shear_at = [&](double s) { return update_contact(law, {-1e-30, s}, rest).traction.shear; };
        const auto normal_at = [&](double o) { return update_contact(law, {o, 0}, rest).traction.normal; };
        verify("law: shear tangent at rest over ks", (shear_at(d) - shear_at(-d)) / (2 * d) / law.ks, 1, 3e-6, "1, to d/dct");
        verify("law: normal tangent at rest over kt", (normal_at(d) - normal_at(-d)) / (2 * d) / law.kt, 1, 3e-6, "1, to d/dct");
        double stiffest = 0;
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            ContactWalk walk(law);
            for (const ContactMotion& corner : random_path(c, seed)) {
                const ContactHistory& h = walk.history();
                const ContactTraction t = walk.go(corner, 50);
                if (std::abs(corner.opening) < d) continue;
                for (const double side : {-d, d}) {
                    const ContactTraction pulled = update_contact(law, {corner.opening + side, corner.sliding}, h).traction;
                    const ContactTraction slid = update_contact(law, {corner.opening, corner.sliding + side}, h).traction;
                    // round-off of tractions of up to 300 MPa over d: 1e-16 · 300 MPa/(kt d) = 2e-10; of shear ten times that
                    EXPECT_LE((pulled.normal - t.normal) / side, law.kt * (1 + 1e-8));
                    EXPECT_LE((slid.shear - t.shear) / side, law.stiffest_shear * (1 + 1e-8));
                    stiffest = std::max(stiffest, (slid.shear - t.shear) / side / law.stiffest_shear);
                }
            }
        }
        EXPECT_GT(stiffest, 0.1);  // the bound is near enough to mean something
    }
}

// Pull past the peak, close, slide until nothing but friction is left, back, open: friction changes its sign, what is lost stays
// lost, the books close.
TEST(ContactLawPaths, ACycleThroughFailure) {
    const ContactParameters c = augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i);
    const double pulled = 0.3 * c.ultimate_opening;
    const double pressure = 20e6;
    const double closed = -pressure / c.normal_stiffness;
    const double residual = pressure * std::tan(c.friction_angle);
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        ContactWalk walk(law);
        const double split = walk.go({pulled, 0}, 4000).normal;
        EXPECT_TRUE(walk.history().failed_open);
        walk.go({closed, 0}, 1000);
        EXPECT_EQ(walk.traction().normal, law.kt * closed);
        EXPECT_EQ(walk.traction().shear, 0);
        walk.go({closed, 8 * c.critical_sliding}, 20000);
        verify("law: cycle, friction there and back over tan(phi) sigma_n", walk.traction().shear / residual, 1, 1e-12, "1");
        walk.go({closed, 0}, 20000);
        verify("law: cycle, friction there and back over tan(phi) sigma_n", -walk.traction().shear / residual, 1, 1e-12, "1");
        walk.go({0.5 * pulled, 0}, 4000);
        EXPECT_LE(walk.traction().normal, 0.5 * split * (1 + 1e-12));  // the secant it has softened to, or less
        verify("law: cycle, work less what was booked over that", walk.balance(), 0, 1e-4, "0 but for jumps within a step",
               walk.fracture() + walk.friction());
    }
}

// What has separated pulls no more, however it is moved; it pushes and rubs when closed.
TEST(ContactLawPaths, ASeparatedContactOnlyPushesAndRubs) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : every_law(c)) {
        SCOPED_TRACE(name_of(law.variant));
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            ContactHistory h = broken_contact();
            int pushed = 0;
            for (const ContactMotion& m : random_path(c, seed)) {
                const ContactResponse r = update_contact(law, m, h);
                if (m.opening >= 0) {
                    EXPECT_EQ(r.traction.normal, 0);
                    EXPECT_EQ(r.traction.shear, 0);
                } else {
                    EXPECT_EQ(r.traction.normal, law.kt * m.opening);
                    EXPECT_LE(std::abs(r.traction.shear), -r.traction.normal * law.tan_phi * (1 + 1e-15));
                    ++pushed;
                }
                EXPECT_EQ(r.dissipation.fracture, 0);
                EXPECT_EQ(point_state(r.history), PointState::separated);
                h = r.history;
            }
            EXPECT_GT(pushed, 0);
        }
    }
}

}  // namespace
}  // namespace graincrack
