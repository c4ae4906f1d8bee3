// What every contact law does on any path: energy is conserved and nothing heals, tractions follow from the stored energy, and
// the responses without a branch are those of the law. A new law is tested here as soon as it stands in the table of laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using Path = std::vector<ContactMotion>;

/// The laws in the order of their table, then those that may have bridges, with them.
class EveryContactLaw : public testing::TestWithParam<std::size_t> {
protected:
    static constexpr unsigned n_paths = 24;
    const ContactParameters c = augig_contact();
    const ContactLaw law = every_law(c)[GetParam()];

    /// A number in (−1, 1) that is the same everywhere.
    static double next(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; }
    /// Twelve corners: openings within ±2 δct, every third up to half of δut; sliding within ±2 δcs.
    [[nodiscard]] Path random_path(unsigned seed) const {
        std::mt19937_64 generator(seed);
        Path path;
        for (int i = 0; i < 12; ++i) {
            const double reach = i % 3 == 2 ? 0.5 * c.ultimate_opening : 2 * c.critical_opening;
            const double opening = reach * next(generator);
            // not closed by more than 200 MPa
            path.push_back({std::max(opening, -200 * MPa / c.normal_stiffness), 2 * c.critical_sliding * next(generator)});
        }
        return path;
    }
    /// The same, open or closed all the time.
    [[nodiscard]] Path one_sided_path(unsigned seed, double side) const {
        Path path = random_path(seed);
        for (ContactMotion& m : path) m.opening = side * (std::abs(m.opening) + 1e-3 * c.critical_opening);
        return path;
    }
    static ContactWalk led_along(const ContactLaw& law, const Path& path, int steps, double mirror = 1,
                                 const ContactHistory& start = {}) {
        ContactWalk walk(law, start);
        for (const ContactMotion& corner : path) walk.go({corner.opening, mirror * corner.sliding}, steps);
        return walk;
    }
    /// Sums over paths of |work − stored − booked| in steps that halve from one to the next, over what was booked.
    template <class PathOfSeed>
    std::array<double, 4> balances(const PathOfSeed& path) const {
        std::array<double, 4> error{};
        double booked = 0;
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            for (std::size_t i = 0; i < error.size(); ++i) {
                const ContactWalk walk = led_along(law, path(seed), 250 << i);
                error[i] += std::abs(walk.balance());
                booked += (walk.fracture() + walk.friction()) / static_cast<double>(error.size());
            }
        }
        EXPECT_GT(booked, n_paths * 0.1 * c.fracture_energy);
        for (double& sum : error) sum /= booked;
        return error;
    }
    /// Calls `action` with an object of the law's type.
    template <class Action>
    auto with_type(const Action& action) const {
        return contact_law::with_law(law.variant, action);
    }
};

// Each term of the dissipation is the fall of an energy or friction against slip, so that none is negative in any update, but for
// round-off of Gf; damage never decreases.
TEST_P(EveryContactLaw, NeverDissipatesLessThanNothingAndNeverHeals) {
    for (const auto kind : {FractureEnergyChoice::Kind::mixed, FractureEnergyChoice::Kind::mode_i}) {
        const ContactParameters contact = augig_contact(PlaneCondition::strain, kind);
        unsigned failed = 0;
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            for (const int steps : {40, 500}) {  // the coarser of up to a tenth of δcs
                const ContactWalk walk = led_along(every_law(contact)[GetParam()], random_path(seed), steps);
                verify_between("law: random paths, least fracture dissipation of an update over Gf",
                               walk.min_fracture() / contact.fracture_energy, -1e-12, HUGE_VAL, "never negative");
                verify_between("law: random paths, least friction of an update over Gf",
                               walk.min_friction() / contact.fracture_energy, 0, HUGE_VAL, "never negative");
                EXPECT_GE(walk.stored(), 0);
                EXPECT_FALSE(walk.healed());
                failed += walk.history().failed() ? 1 : 0;
            }
        }
        EXPECT_GT(failed, n_paths);  // of twice as many, or nothing was tried
    }
}

// Work = stored + fracture + friction + non-conservative work, up to an error that halves with the step: tractions jump where a
// peak is passed and where branches meet, and a trapezium over a jump is wrong by half of it times the step.
TEST_P(EveryContactLaw, BooksItsWorkToTheStep) {
    const auto error = balances([&](unsigned seed) { return random_path(seed); });
    verify("law: random paths, work less what was booked over that", error.back(), 0, 2e-4, "0 but for jumps within a step", 1);
    EXPECT_LT(error.back(), error.front() / 4);  // 1/8 but for where the jumps fall in a step
}

// The same without jumps: opened and slid only, in the laws that soften (coulomb-slip falls). The error falls with the square of
// the step: 1/64, but that the last step of a path may end anywhere in it.
TEST_P(EveryContactLaw, BooksItsWorkToSecondOrderWhereTractionsDoNotJump) {
    if (law.variant == LawVariant::coulomb_slip) return;
    const auto error = balances([&](unsigned seed) { return one_sided_path(seed, 1); });
    verify_between("law: open random paths, error of the energy at an eighth of the step over that of the whole, " +
                       std::string(name_of(law.variant)),
                   error.back() / error.front(), 0, 1.0 / 32, "1/64: second order");
}

// Friction of a broken contact is piecewise linear: trapezia are exact, and nothing is left over but round-off.
TEST_P(EveryContactLaw, BooksFrictionOfABrokenContactExactly) {
    for (unsigned seed = 0; seed < n_paths; ++seed) {
        const ContactWalk rubbed = led_along(law, one_sided_path(seed, -1), 500, 1, broken_contact());
        EXPECT_GT(rubbed.friction(), 0);
        verify("law: broken and closed, work less what was booked over that", rubbed.balance(), 0, 1e-12,
               "piecewise linear: trapezia are exact", rubbed.friction());
    }
}

// A step that turns from slip to slip the other way while the limit falls: the trapezium is negative there, nothing is booked
// (solver/law/friction.hpp), and what is missing is no more than ½ τ |Δδs|. In all other steps friction is the trapezium, to the
// round-off of ks (δs − slip) and of two squares.
TEST_P(EveryContactLaw, BooksTheTrapeziumOfFrictionOrNothing) {
    std::mt19937_64 generator(3);
    ContactHistory h = broken_contact();
    h.motion.opening = -1e-12;
    int turned = 0, slipped = 0;
    for (int i = 0; i < 2000; ++i) {
        const ContactMotion to{-1e-7 * (1.01 + next(generator)), c.critical_sliding * next(generator)};
        const ContactResponse r = update_contact(law, to, h);
        const double before = law.ks * (h.motion.sliding - h.slip);
        const double after = r.traction.shear;
        const double moved = to.sliding - h.motion.sliding;
        const double wanted = 0.5 * (before + after) * moved - 0.5 * (after * after - before * before) / law.ks;
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

// Sliding to the left is sliding to the right: the same to the bit.
TEST_P(EveryContactLaw, IsSymmetricInSliding) {
    for (unsigned seed = 0; seed < n_paths; ++seed) {
        const ContactWalk walk = led_along(law, random_path(seed), 200);
        const ContactWalk mirrored = led_along(law, random_path(seed), 200, -1);
        EXPECT_EQ(walk.traction().normal, mirrored.traction().normal);
        verify("law: shear of the mirrored path over tc", -mirrored.traction().shear, walk.traction().shear, 0x1p-60,
               "the same, to the bit", law.tc);
        EXPECT_EQ(walk.fracture(), mirrored.fracture());
        EXPECT_EQ(walk.friction(), mirrored.friction());
        EXPECT_EQ(walk.non_conservative(), mirrored.non_conservative());
        EXPECT_EQ(walk.history().failed_open, mirrored.history().failed_open);
    }
}

// Where a law has a potential, nothing may be left over but round-off of Gf: on closed paths and in opening without sliding; in
// laws that say they have one everywhere, on any path.
TEST_P(EveryContactLaw, DoesNoNonConservativeWorkWhereItHasAPotential) {
    double others = 0;
    for (unsigned seed = 0; seed < n_paths; ++seed) {
        Path opening = random_path(seed);
        for (ContactMotion& m : opening) m = {std::abs(m.opening), 0};
        // Closed from the first step on.
        const ContactWalk pushed = led_along(law, one_sided_path(seed, -1), 200, 1, {.motion = {-1e-30, 0}});
        EXPECT_EQ(pushed.non_conservative(), 0);
        EXPECT_GT(pushed.work(), 0);
        const ContactWalk pulled = led_along(law, opening, 200);
        expect_close(pulled.non_conservative(), 0, 1e-12, c.fracture_energy);
        EXPECT_GT(pulled.fracture(), 0);
        others = std::max(others, std::abs(led_along(law, random_path(seed), 200).non_conservative()));
    }
    if (description_of(law.variant).potential) {
        verify("law: random paths, non-conservative work over Gf, " + std::string(name_of(law.variant)), others, 0, 1e-12,
               "it has a potential", c.fracture_energy);
    } else {
        EXPECT_GT(others, 1e-6 * c.fracture_energy);  // elsewhere these have some
    }
}

// An intact point that opens while it carries shear falls to the open curve, never rises, and closes again without a jump
// (tolerance: motions of 1e-12 δct). `literal`, which has no potential, jumps there (LiteralLaw).
TEST_P(EveryContactLaw, DoesNotRiseWhereItOpens) {
    if (!description_of(law.variant).potential) return;
    const double tiny = 1e-12 * c.critical_opening;
    for (const double sliding : {0.01 * c.critical_sliding, 0.1 * c.critical_sliding, 0.3 * c.critical_sliding}) {
        ContactWalk walk(law);
        walk.to({-tiny, 0});
        const double closed = walk.go({-tiny, sliding}, 100).shear;
        const double open = walk.to({tiny, sliding}).shear;
        EXPECT_LE(open, closed * (1 + 1e-9));
        const double load = sliding * law.inv_dso;  // of laws that are stretched by δs/δso while open
        if (law.inv_dso > 0 && load < 1) expect_close(open, law.ks * sliding * std::exp(-load), 1e-9, closed);
        expect_close(walk.to({-tiny, sliding}).shear, open, 1e-9, closed);
        expect_close(walk.non_conservative(), 0, 1e-12, c.fracture_energy);
    }
}

// With its history fixed the traction is the gradient of the stored energy, in any state. Central differences are off by d²/6 of
// the third derivative and by round-off of energies of up to 200 MPa · δcs: 1e-16 · 300 J/m² / d.
TEST_P(EveryContactLaw, HasTheTractionsOfItsStoredEnergy) {
    const double d = 1e-5 * c.critical_opening;
    const std::string name = "law: traction less the slope of the energy over tc, " + std::string(name_of(law.variant));
    int open = 0, closed = 0;
    for (unsigned seed = 0; seed < n_paths; ++seed) {
        ContactWalk walk(law);
        for (const auto& [o, s] : random_path(seed)) {
            walk.go({o, s}, 50);
            if (std::abs(o) < 2 * d) continue;
            const auto energy = [&](double opening, double sliding) {
                ContactHistory at = walk.history();
                at.motion = {opening, sliding};
                return stored_energy(law, at);
            };
            const double normal = (energy(o + d, s) - energy(o - d, s)) / (2 * d);
            const double shear = (energy(o, s + d) - energy(o, s - d)) / (2 * d);
            verify(name, walk.traction().normal, normal, 2e-8, "central differences", law.tc);
            verify(name, walk.traction().shear, shear, 2e-8, "central differences", law.tc);
            (o > 0 ? open : closed) += 1;
        }
    }
    EXPECT_GT(open, 50);
    EXPECT_GT(closed, 50);
}

// The tangent by differences: kt and ks at rest, to d/δct, and nowhere more than the stable time step was made for, to the
// round-off of tractions of up to 300 MPa over d: 1e-16 · 300 MPa/(kt d) = 2e-10, of shear ten times that.
TEST_P(EveryContactLaw, IsNowhereStifferThanTheTimeStepKnows) {
    const double d = 1e-6 * c.critical_opening;
    const ContactHistory rest{.motion = {-1e-30, 0}};
    const auto shear_at = [&](double s) { return update_contact(law, {-1e-30, s}, rest).traction.shear; };
    const auto normal_at = [&](double o) { return update_contact(law, {o, 0}, rest).traction.normal; };
    verify("law: shear tangent at rest over ks", (shear_at(d) - shear_at(-d)) / (2 * d) / law.ks, 1, 3e-6, "1, to d/dct");
    verify("law: normal tangent at rest over kt", (normal_at(d) - normal_at(-d)) / (2 * d) / law.kt, 1, 3e-6, "1, to d/dct");
    double stiffest = 0;
    for (unsigned seed = 0; seed < n_paths; ++seed) {
        ContactWalk walk(law);
        for (const ContactMotion& corner : random_path(seed)) {
            const ContactTraction t = walk.go(corner, 50);
            if (std::abs(corner.opening) < d) continue;
            for (const double side : {-d, d}) {
                const ContactTraction pulled =
                    update_contact(law, {corner.opening + side, corner.sliding}, walk.history()).traction;
                const ContactTraction slid =
                    update_contact(law, {corner.opening, corner.sliding + side}, walk.history()).traction;
                EXPECT_LE((pulled.normal - t.normal) / side, law.kt * (1 + 1e-8));
                EXPECT_LE((slid.shear - t.shear) / side, law.stiffest_shear * (1 + 1e-8));
                stiffest = std::max(stiffest, (slid.shear - t.shear) / side / law.stiffest_shear);
            }
        }
    }
    EXPECT_GT(stiffest, 0.1);  // the bound is near enough to mean something
}

// Pulled past the peak, closed, slid until nothing but tan φ σn is left, back, opened: friction changes its sign, what is lost
// stays lost, the energy balance closes but for jumps within a step.
TEST_P(EveryContactLaw, KeepsItsLossesInACycleThroughFailure) {
    const ContactParameters brittle = augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i);
    const double pulled = 0.3 * brittle.ultimate_opening;
    const double closed = -20 * MPa / brittle.normal_stiffness;
    const double residual = 20 * MPa * std::tan(brittle.friction_angle);
    ContactWalk walk(every_law(brittle)[GetParam()]);
    const double split = walk.go({pulled, 0}, 4000).normal;
    EXPECT_TRUE(walk.history().failed_open);
    walk.go({closed, 0}, 1000);
    EXPECT_EQ(walk.traction().normal, law.kt * closed);
    EXPECT_EQ(walk.traction().shear, 0);
    for (const double sliding : {8 * brittle.critical_sliding, 0.0}) {
        walk.go({closed, sliding}, 20000);
        verify("law: cycle, friction there and back over tan(phi) sigma_n",
               (sliding > 0 ? 1 : -1) * walk.traction().shear / residual, 1, 1e-12, "1");
    }
    walk.go({0.5 * pulled, 0}, 4000);
    EXPECT_LE(walk.traction().normal, 0.5 * split * (1 + 1e-12));  // the secant it has softened to, or less
    verify("law: cycle, work less what was booked over that", walk.balance(), 0, 1e-4, "0 but for jumps within a step",
           walk.fracture() + walk.friction());
}

// What has separated, as a pre-existing crack, pulls no more, however it is moved; it pushes with kt and rubs within tan φ.
TEST_P(EveryContactLaw, OnlyPushesAndRubsOnceSeparated) {
    EXPECT_EQ(remaining_cohesion(law, broken_contact()), 0);
    for (unsigned seed = 0; seed < n_paths; ++seed) {
        ContactHistory h = broken_contact();
        int pushed = 0;
        for (const ContactMotion& m : random_path(seed)) {
            const ContactResponse r = update_contact(law, m, h);
            const bool open = m.opening >= 0;
            EXPECT_EQ(r.traction.normal, open ? 0 : law.kt * m.opening);
            EXPECT_LE(std::abs(r.traction.shear), open ? 0 : -r.traction.normal * law.tan_phi * (1 + 1e-15));
            EXPECT_EQ(r.dissipation.fracture, 0);
            EXPECT_EQ(point_state(r.history), PointState::separated);
            pushed += open ? 0 : 1;
            h = r.history;
        }
        EXPECT_GT(pushed, 0);
    }
}

// A contact parameter that the law does not name leaves its responses as they are, to the bit.
TEST_P(EveryContactLaw, IgnoresTheParametersItDoesNotName) {
    const Path path = random_path(1);
    const ContactWalk walk = led_along(make_contact_law(c, law.variant), path, 200);
    for (const ContactParameter& row : all_contact_parameters()) {
        if (row.every_law || description_of(law.variant).reads(row.value)) continue;
        ContactParameters changed = c;
        changed.*row.value += 0.5 * std::abs(changed.*row.value) + 1e-3;
        const ContactWalk other = led_along(make_contact_law(changed, law.variant), path, 200);
        EXPECT_EQ(other.history(), walk.history()) << row.quantity.name;
        EXPECT_EQ(other.work(), walk.work()) << row.quantity.name;
        EXPECT_EQ(other.fracture(), walk.fracture()) << row.quantity.name;
    }
}

// The branch-free response of intact points is that of `update_contact` wherever it says that it holds, to the round-off of some
// products. It holds for points that stay on their side of δn = 0 short of the peak; over δn = 0 only in laws that are one there.
TEST_P(EveryContactLaw, AgreesWithItsIntactResponse) {
    const auto intact = [&](const MovedPoint& point) {
        return with_type([&](auto kind) { return decltype(kind)::intact(law, point); });
    };
    const bool damages_intact = with_type([](auto kind) { return decltype(kind)::damages_intact; });
    int held = 0, failed = 0, damaged = 0;
    for (double opening = -3; opening < 1.3; opening += 0.17) {
        for (double sliding = -2; sliding < 2; sliding += 0.13) {
            for (const double left : {1.0, 0.7}) {
                const double reach = opening < 0 ? law.dcs : law.dct;
                const ContactMotion to{opening * law.dct, sliding * reach};
                const ContactHistory before{.motion = {opening < 0 ? -1e-12 : 1e-9, 0.4 * reach},
                                            .integrity = damages_intact ? left : 1};
                const IntactResponse r =
                    intact({before.motion.opening, before.motion.sliding, to.opening, to.sliding, before.integrity});
                const ContactResponse full = update_contact(law, to, before);
                failed += full.history.failed() ? 1 : 0;
                EXPECT_EQ(full.history.failed(), r.holds == 0);
                if (r.holds == 0) continue;
                ++held;
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
    EXPECT_EQ(damaged > 100, damages_intact);
    EXPECT_EQ(intact({1e-12, 0, -1e-12, 0, 1}).holds,
              law.variant == LawVariant::coulomb_slip || law.variant == LawVariant::combined ? 1 : 0);
}

// The same of points of which friction is left, in laws that have such points, to the bit, unless δn = 0 is crossed.
TEST_P(EveryContactLaw, AgreesWithItsResidualResponse) {
    const auto is_residual = [&](const ContactHistory& h) {
        return with_type([&](auto kind) { return decltype(kind)::is_residual(law, h); });
    };
    ContactHistory h = broken_contact();
    int slid = 0;
    for (int k = 0; k < 4000 && is_residual(h); ++k) {
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
    EXPECT_EQ(slid > 500, is_residual(broken_contact()));
}

void expect_equal(const ContactLaw& law, const SofteningResponse& softening, const ContactResponse& full) {
    EXPECT_EQ(softening.normal, full.traction.normal);
    EXPECT_EQ(softening.shear, full.traction.shear);
    EXPECT_EQ(softening.integrity, full.history.integrity);
    EXPECT_EQ(softening.slip, full.history.slip);
    EXPECT_EQ(softening.largest_open, full.history.largest_open);
    EXPECT_EQ(softening.largest_slid, full.history.largest_slid);
    EXPECT_EQ(softening.bridge, full.history.bridge);
    EXPECT_EQ(softening.remaining_cohesion, remaining_cohesion(law, full.history));
    EXPECT_EQ(softening.fracture, full.dissipation.fracture);
    EXPECT_EQ(softening.friction, full.dissipation.friction);
    EXPECT_EQ(full.dissipation.non_conservative_work, 0);
}

// The same of points that soften, in laws that have a response for them, to the bit. Paths start just past the peak of sliding
// under a pressure, at e cc/ks or 2 cc/ks (combined), then swing between pressure and opening, past its peak at last, while they
// slide to and fro, farther and farther.
TEST_P(EveryContactLaw, AgreesWithItsSofteningResponse) {
    ContactParameters weak = weak_contact();
    weak.residual_friction_angle = 20 * degree;
    const ContactLaw softens = every_law(weak)[GetParam()];
    const double peak = (law.variant == LawVariant::combined ? 2 : std::exp(1.0)) * weak.cohesion / weak.shear_stiffness;
    with_type([&](auto kind) {
        using Law = decltype(kind);
        if constexpr (requires(MovedPoint p) { Law::softening(softens, p); }) {
            int held = 0, slid = 0;
            for (int seed = 0; seed < 20; ++seed) {
                const double opening = -5 * MPa / law.kt;
                ContactWalk walk(softens, {.motion = {opening, 0}});
                walk.go({opening, 1.01 * peak}, 10);
                for (int k = 1; k < 500; ++k) {
                    const ContactHistory h = walk.history();
                    const ContactMotion to{opening * (1 + (1.2 + 0.03 * k) * std::sin(0.013 * k * (1 + seed))),
                                           peak * (1 + 0.2 * k * std::sin(0.05 * k + seed))};
                    const auto softening = contact_law::softening_response<Law>(softens, contact_law::moved_point(h, to));
                    const ContactResponse full = update_contact(softens, to, h);
                    walk.to(to);
                    if (softening.holds == 0 || Law::is_residual(softens, h)) continue;
                    ++held;
                    slid += softening.friction > 0 ? 1 : 0;
                    expect_equal(softens, softening, full);
                }
            }
            EXPECT_GT(held, 500);
            EXPECT_GT(slid, 100);
        }
    });
}

std::string name_of_row(const testing::TestParamInfo<std::size_t>& row) {
    const ContactLaw law = every_law(augig_contact())[row.param];
    std::string name = std::string(name_of(law.variant)) + (law.bridge > 0 ? "_bridged" : "");
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(, EveryContactLaw, testing::Range(std::size_t{0}, every_law(augig_contact()).size()), name_of_row);

}  // namespace
}  // namespace graincrack::test
