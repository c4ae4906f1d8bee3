// When the contact points of a run are damaged and broken: the events of its steps against the law.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/detection/pair_list.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/linear_statics.hpp"

namespace graincrack::test {
namespace {

/// A grid that platens compress until it has failed, step by step. After each step the law is asked what remains of the
/// points that have failed or lost cohesion in it.
void expect_events_in_their_steps(LawVariant variant, VectorTarget target) {
    SCOPED_TRACE(name_of(variant));
    SmallRun run(jittered_grid(8, 16, 0.04, 0.08, 0.25), make_contact_law(weak_contact(), variant));
    run.assemblage.vector_target = target;
    run.parameters.damping = 0.8;
    run.load_by({.platen_friction = 0.1, .max_strain = 0.05}, 0.7, weak_contact());
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
            ASSERT_EQ(run.state.next_level[point], damage_level(expected[point])) << "step " << k;
        }
        for (std::vector<ContactEvent>& chunk : run.state.events) {
            for (const ContactEvent& event : chunk) {
                const std::size_t point = 2 * static_cast<std::size_t>(event.contact) + event.point;
                EXPECT_EQ(event.step, run.state.step);
                EXPECT_EQ(event.motion, (ContactMotion{run.state.opening[point], run.state.sliding[point]}));
                passed += event.kind == ContactEventKind::broken ? 1U : 0U;
            }
            chunk.clear();
        }
    }
    EXPECT_GT(passed, 20U);
    EXPECT_EQ(passed, static_cast<std::size_t>(std::count(expected.begin(), expected.end(), damage_levels.size())));
}

// Each damage level that the law says a point has passed is an event of that step, with its motion, exactly; points take the full
// law in some steps and the vector path in others.
TEST(BrokenPoint, IsAnEventOfItsStepOnEveryPath) {
    for (const LawDescription& law : all_contact_laws()) expect_events_in_their_steps(law.variant, widest_vector_target());
    expect_events_in_their_steps(LawVariant::cohesive_frictional, VectorTarget::plain);
}

// --- a grain that turns around its neighbour on the last bond between them ------------------------------------------------

/// Two grains of one contact, the second of which is turned about the contact's first end.
struct Hinge {
    SmallRun run;
    explicit Hinge(LawVariant variant) : run(one_diagonal_grid(1, 1, 0.01, 0.01), augig_law(variant)) { run.begin(); }

    /// Evaluates contacts and updates the list of pairs, as steps do.
    void turn_to(double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const auto& nodes = run.assemblage.contacts[0].nodes;
        const Vector2 centre = run.assemblage.position[nodes[0]];
        const auto& grain = run.assemblage.surface.grain_of_node;
        for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
            if (grain[i] != grain[nodes[2]]) continue;
            const Vector2 r = run.assemblage.position[i] - centre;
            run.state.displacement[i] = {(std::cos(angle) - 1) * r.x - std::sin(angle) * r.y,
                                         std::sin(angle) * r.x + (std::cos(angle) - 1) * r.y};
        }
        run.begin();
        update_pair_list(run.assemblage, run.parameters, run.state);
    }
    [[nodiscard]] double largest_force() const { return largest_length(forces_at(run, run.state, run.state.displacement)); }
};

constexpr LawVariant laws_that_lose_frames[] = {LawVariant::consistent, LawVariant::cohesive_frictional};

// A grain is turned by 210° about one end of its last bond: the far end opens, then the bond breaks, with forces below a
// thousandth of what the contact bears, and dissipates what was left of the fracture energy, from half of it on, whatever the
// opening of the lost frame.
TEST(LostFrame, BreaksTheBondOnWhichAGrainTurnsOver) {
    for (const LawVariant law : laws_that_lose_frames) {
        Hinge hinge(law);
        const ContactPairList& list = hinge.run.state.contact_pairs;
        // The sense in which the contact opens.
        hinge.turn_to(1e-4);
        const double sense = hinge.run.state.opening[1] > 0 ? 1 : -1;
        for (double degrees = 1; degrees <= 150; ++degrees) hinge.turn_to(sense * degrees);
        EXPECT_EQ(list.debonded[1], 1) << "the far end has opened";
        EXPECT_EQ(list.debonded[0], 0) << "the near end has not moved";
        EXPECT_EQ(list.released[0], 0);
        for (double degrees = 151; degrees <= 210; ++degrees) {
            hinge.turn_to(sense * degrees);
            // A thousandth of what the contact bears; turned over, the far end would overlap by the diagonal of the square.
            EXPECT_LT(hinge.largest_force(), 1e-3 * 24e6 * hinge.run.assemblage.contacts[0].point_area) << degrees;
        }
        EXPECT_EQ(list.debonded[0], 1);
        EXPECT_EQ(list.released[0], 1);
        // What was left of the fracture energy is dissipated, whatever the opening that stands for the lost frame.
        const ContactLaw& constants = hinge.run.parameters.laws[0];
        const double whole = constants.gf * hinge.run.assemblage.contacts[0].point_area;
        EXPECT_GT(hinge.run.state.fracture_energy[0], 0.5 * whole);
        EXPECT_LT(hinge.run.state.fracture_energy[0], 1.1 * whole);
    }
}

}  // namespace
}  // namespace graincrack::test
