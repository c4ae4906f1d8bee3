// The contact law on random paths: what must hold for every reading whatever the motion.
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

using test::all_laws;
using test::augig_contact;
using test::ContactWalk;
using test::expect_close;
using test::name_of_law;
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

ContactWalk led_along(const ContactLaw& law, const Path& path, int steps, double mirror = 1) {
    ContactWalk walk(law);
    for (const ContactMotion& corner : path) {
        walk.go({corner.opening, mirror * corner.sliding}, steps);
    }
    return walk;
}

TEST(ContactLawPaths, DissipationIsNeverNegativeAndNothingHeals) {
    for (const auto kind : {FractureEnergyChoice::Kind::mixed, FractureEnergyChoice::Kind::mode_i}) {
        const ContactParameters c = augig_contact(PlaneCondition::strain, kind);
        for (const ContactLaw& law : all_laws(c)) {
            SCOPED_TRACE(name_of_law(law));
            int failed = 0;
            for (unsigned seed = 0; seed < n_paths; ++seed) {
                const int steps = 500;
                const ContactWalk walk = led_along(law, random_path(c, seed), steps);
                verify_between("law: random paths, least fracture dissipation of an update over Gf",
                               walk.least_fracture() / c.fracture_energy, -1e-12, HUGE_VAL, "never negative");
                // Friction over a step that reverses is a trapezium: it may be short by ks times the step's sliding squared.
                const double step = 4 * c.critical_sliding / steps;
                EXPECT_GE(walk.least_friction(), -law.ks * step * step);
                verify_between("law: random paths, friction over Gf", walk.friction() / c.fracture_energy, 0, HUGE_VAL,
                               "never negative");
                EXPECT_GE(walk.stored(), 0);
                EXPECT_FALSE(walk.healed());
                failed += walk.history().failed() ? 1 : 0;
            }
            EXPECT_GT(failed, n_paths / 2);  // or nothing was tried
        }
    }
}

// Work = stored + fracture + friction + mismatch, up to an error that halves with the step: tractions jump where a peak is
// passed and where branches meet, and a trapezium over a jump is wrong by half of it times the step.
TEST(ContactLawPaths, WorkIsWhatWasBookedToTheStep) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : all_laws(c)) {
        SCOPED_TRACE(name_of_law(law));
        std::array<double, 4> error{};
        double booked = 0;
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            int steps = 250;
            for (double& sum : error) {
                const ContactWalk walk = led_along(law, random_path(c, seed), steps);
                sum += std::abs(walk.balance());
                booked += walk.fracture() + walk.friction();
                steps *= 2;
            }
        }
        booked /= static_cast<double>(error.size());
        EXPECT_GT(booked, n_paths * 0.1 * c.fracture_energy);
        verify("law: random paths, work less what was booked over that", error.back(), 0, 2e-4, "0 but for jumps within a step",
               booked);
        EXPECT_LT(error.back(), error.front() / 4);  // 1/8 but for the luck of where the jumps fall in a step
    }
}

TEST(ContactLawPaths, MirrorSymmetryInSliding) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : all_laws(c)) {
        SCOPED_TRACE(name_of_law(law));
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            const ContactWalk walk = led_along(law, random_path(c, seed), 200);
            const ContactWalk mirrored = led_along(law, random_path(c, seed), 200, -1);
            EXPECT_EQ(walk.traction().normal, mirrored.traction().normal);
            verify("law: shear of the mirrored path over tc", -mirrored.traction().shear, walk.traction().shear, 0x1p-60,
                   "the same, to the bit", law.tc);
            EXPECT_EQ(walk.fracture(), mirrored.fracture());
            EXPECT_EQ(walk.friction(), mirrored.friction());
            EXPECT_EQ(walk.mismatch(), mirrored.mismatch());
            EXPECT_EQ(walk.history().failed_open, mirrored.history().failed_open);
        }
    }
}

// Where a reading has a potential, nothing may be left over: closed paths, and opening without sliding.
TEST(ContactLawPaths, NoMismatchWhereThereIsAPotential) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : all_laws(c)) {
        SCOPED_TRACE(name_of_law(law));
        double others = 0;
        for (unsigned seed = 0; seed < n_paths; ++seed) {
            Path closed = random_path(c, seed);
            Path opening = random_path(c, seed);
            for (ContactMotion& m : closed) {
                m.opening = -std::abs(m.opening) - 1e-3 * c.critical_opening;
            }
            for (ContactMotion& m : opening) {
                m = {std::abs(m.opening), 0};
            }
            ContactWalk walk(law);
            walk.to({closed.front().opening, 0});
            for (const ContactMotion& corner : closed) {
                walk.go(corner, 200);
            }
            EXPECT_EQ(walk.mismatch(), 0);
            EXPECT_GT(walk.work(), 0);
            const ContactWalk pulled = led_along(law, opening, 200);
            expect_close(pulled.mismatch(), 0, 1e-12, c.fracture_energy);
            EXPECT_GT(pulled.fracture(), 0);
            others += std::abs(led_along(law, random_path(c, seed), 200).mismatch());
        }
        EXPECT_GT(others, 0);  // elsewhere every reading has some
    }
}

// What has separated pulls no more, however it is moved; it pushes and rubs when closed.
TEST(ContactLawPaths, ASeparatedContactOnlyPushesAndRubs) {
    const ContactParameters c = augig_contact();
    for (const ContactLaw& law : all_laws(c)) {
        SCOPED_TRACE(name_of_law(law));
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
