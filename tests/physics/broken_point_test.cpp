// When a contact point is damaged and broken: each law against its closed form, and the steps of a run against the law.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack {
namespace {

using test::all_laws;
using test::ContactWalk;
using test::SmallRun;
using test::weak_contact;

/// D at which z(D) of `combined` is `remaining`, by bisection.
double damage_of_combined(double remaining) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (contact_law::munjiza_softening(middle) > remaining ? low : high) = middle;
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

/// What is left at 10, 50 and 90 % of damage.
constexpr double marks[] = {0.9, 0.5, 0.1};

/// Walks along `direction` in equal steps and expects each mark to be passed in the step that crosses its closed form.
template <class Place>
void expect_marks_at(const ContactLaw& law, const ContactMotion& direction, const Place& place) {
    SCOPED_TRACE(name_of(law.variant));
    const double step = place(law, 0.1) / 9973.5;
    ContactWalk walk(law);
    std::size_t passed = 0;
    for (int k = 1; k <= 10000; ++k) {
        walk.to({direction.opening * k * step - (direction.opening == 0 ? 1e-30 : 0), direction.sliding * k * step});
        const std::size_t now = count_levels_above(remaining_cohesion(law, walk.history()));
        for (; passed < now; ++passed) {
            const double expected = place(law, marks[passed]);
            EXPECT_GT(k * step, expected * (1 - 1e-9));
            EXPECT_LE((k - 1) * step, expected * (1 + 1e-9));
            EXPECT_TRUE(walk.history().failed());
        }
        EXPECT_EQ(passed, now);  // nothing heals
    }
    EXPECT_EQ(passed, damage_levels.size());
}

TEST(BrokenPoint, PureOpeningPassesTheMarksWhereTheClosedFormSays) {
    for (const ContactLaw& law : all_laws(weak_contact())) expect_marks_at(law, {1, 0}, opening_where);
}

TEST(BrokenPoint, PureSlidingPassesTheMarksWhereTheClosedFormSays) {
    for (const ContactLaw& law : all_laws(weak_contact())) {
        expect_marks_at(law, {0, 1}, sliding_where);
        expect_marks_at(law, {0, -1}, sliding_where);
    }
}

// In pure opening a point can bear what remains, times its peak.
TEST(BrokenPoint, TheTractionIsWhatRemainsOfThePeak) {
    for (const ContactLaw& law : all_laws(weak_contact())) {
        SCOPED_TRACE(name_of(law.variant));
        ContactWalk walk(law);
        EXPECT_EQ(remaining_cohesion(law, walk.history()), 1);
        walk.go({0.999 * opening_where(law, 1), 0}, 100);
        EXPECT_EQ(remaining_cohesion(law, walk.history()), 1);
        for (const double remaining : {0.95, 0.6, 0.2, 0.05}) {
            walk.go({opening_where(law, remaining) * (1 + 1e-9), 0}, 100);
            test::expect_close(walk.traction().normal, remaining_cohesion(law, walk.history()) * law.tc, 1e-6, law.tc);
        }
    }
}

// What a broken contact bears by its residual cohesion and friction is no cohesion that it could lose.
TEST(BrokenPoint, ResidualCohesionIsThatOfABrokenPoint) {
    ContactParameters c = weak_contact();
    c.residual_cohesion = 5 * test::MPa;
    const ContactLaw law = make_contact_law(c, LawVariant::coulomb_slip);
    ContactWalk walk(law);
    walk.go({-1e-30, 1.01 * law.cc / law.ks}, 100);
    test::expect_close(walk.traction().shear, c.residual_cohesion, 1e-9, c.cohesion);
    EXPECT_EQ(remaining_cohesion(law, walk.history()), 0);
}

TEST(BrokenPoint, PreExistingCracksAreBroken) {
    for (const ContactLaw& law : all_laws(weak_contact())) EXPECT_EQ(remaining_cohesion(law, broken_contact()), 0);
}

/// A grid that platens compress until it has failed, step by step. After each step the law is asked what remains of the
/// points that have failed or lost cohesion in it.
void expect_events_in_their_steps(LawVariant variant, VectorTarget target) {
    SCOPED_TRACE(name_of(variant));
    SmallRun run(test::jittered_grid(8, 16, 0.04, 0.08, 0.25), make_contact_law(weak_contact(), variant));
    LoadingRequest loading;
    loading.platen_friction = 0.1;
    loading.max_strain = 0.05;
    run.assemblage.vector_target = target;
    run.parameters.damping = 0.8;
    run.set_boundary(test::boundary_of_test(run.assemblage, run.specimen, loading, weak_contact()), 0.7);
    run.begin();
    constexpr double speed = 2;                                  // m/s
    std::vector<std::size_t> expected(run.state.failed.size());  // marks passed
    std::size_t passed = 0;
    for (int k = 0; k < 4000; ++k) {
        const std::vector<double> released = run.state.fracture_energy;
        const std::vector<std::uint8_t> failed = run.state.failed;
        run.steps(1, {{speed, -speed}, {speed, -speed}, nullptr});
        for (std::size_t point = 0; point < expected.size(); ++point) {
            const ContactHistory now = point_history(run.state, point);
            if (run.state.fracture_energy[point] > released[point] || run.state.failed[point] != failed[point]) {
                expected[point] = std::max(expected[point], count_levels_above(remaining_cohesion(run.parameters.laws[0], now)));
            }
        }
        for (std::size_t point = 0; point < expected.size(); ++point) {
            ASSERT_EQ(run.state.next_level[point], damage_level(expected[point])) << "step " << k;
        }
        for (const std::vector<ContactEvent>& chunk : run.state.events) {
            for (const ContactEvent& event : chunk) {
                const std::size_t point = 2 * static_cast<std::size_t>(event.contact) + event.point;
                EXPECT_EQ(event.step, run.state.step);
                EXPECT_EQ(event.motion, (ContactMotion{run.state.opening[point], run.state.sliding[point]}));
                passed += event.kind == ContactEventKind::broken ? 1U : 0U;
            }
        }
        for (std::vector<ContactEvent>& chunk : run.state.events) chunk.clear();
    }
    EXPECT_GT(passed, 20U);
    EXPECT_EQ(passed, static_cast<std::size_t>(std::count(expected.begin(), expected.end(), damage_levels.size())));
}

// Points take the full law in some steps and the vector path in others.
TEST(BrokenPoint, EventsAreNotedInTheirStepOnEveryPath) {
    for (const LawDescription& law : all_contact_laws()) expect_events_in_their_steps(law.variant, widest_vector_target());
    expect_events_in_their_steps(LawVariant::cohesive_frictional, VectorTarget::plain);
}

}  // namespace
}  // namespace graincrack
