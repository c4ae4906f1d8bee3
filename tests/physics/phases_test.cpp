// Grains and contacts of several phases.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/detection/node_edge_contact.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::SmallRun;

/// A shaken rectangle after 1,000 steps, without damage, with the history of its measures.
struct Shaken {
    SmallRun run;
    std::vector<std::array<double, 5>> rows;  ///< strain, contact and kinetic energy, forces of the platens
};
Shaken shaken(SmallRun run) {
    LoadingRequest loading;
    loading.platen_friction = 5 * test::degree;
    run.set_boundary(test::boundary_of_test(run.assemblage, run.specimen, loading, test::augig_contact()), 0.5);
    run.parameters.damping = 0.3;
    run.parameters.damping_form = DampingForm::local;  // the sign of a change of force that is hardly one is round-off
    constexpr double speed = 0.2;                      // m/s, of each platen
    run.set_velocity([&](const Vector2& x) { return Vector2{0.05 * std::sin(200 * x.y), -speed * x.y / 0.02}; });
    run.begin();
    Shaken s{std::move(run), {}};
    for (int i = 0; i < 20; ++i) {
        s.run.steps(50, {{speed, -speed}, {speed, -speed}, nullptr});
        const Measurement m = s.run.measured();
        s.rows.push_back({m.energies.strain, m.energies.contact, m.energies.kinetic, m.force_top, m.force_bottom});
    }
    return s;
}

// Contacts of equal classes are worked on in another order than those of one class: nothing but round-off changes.
TEST(Phases, OfEqualValuesChangeNothing) {
    const Specimen s = test::jittered_grid(8, 16, 0.02, 0.04, 0.25);
    const Shaken one = shaken(SmallRun(s, test::augig_law(LawVariant::consistent)));
    const Shaken six = shaken(test::equal_phases(s).run(LawVariant::consistent));
    ASSERT_GT(six.run.assemblage.contact_chunks.size(), one.run.assemblage.contact_chunks.size());
    EXPECT_EQ(one.run.failed_points(), 0U);
    double worst = 0;
    double largest = 0;
    for (std::size_t i = 0; i < one.run.state.displacement.size(); ++i) {
        worst = std::max(worst, length(one.run.state.displacement[i] - six.run.state.displacement[i]));
        largest = std::max(largest, length(one.run.state.displacement[i]));
    }
    ASSERT_GT(largest, 0);
    test::verify("phases: displacements of six equal classes against one, after 1,000 steps", worst / largest, 0, 1e-9,
                 "the same equations in another order", 1);
    for (std::size_t k = 0; k < one.rows.front().size(); ++k) {
        double scale = 0;
        double off = 0;
        for (std::size_t i = 0; i < one.rows.size(); ++i) {
            scale = std::max(scale, std::abs(one.rows[i][k]));
            off = std::max(off, std::abs(one.rows[i][k] - six.rows[i][k]));
        }
        ASSERT_GT(scale, 0);
        EXPECT_LT(off, 1e-9 * scale) << k;
    }
}

// Two grains that touch by a node–edge contact slide at the friction angle of their class, whatever those of other classes are.
TEST(Phases, ANodeEdgeContactHasTheLawOfItsTwoGrains) {
    const double angles[] = {50, 20, 40};
    for (const std::array<std::uint8_t, 2> phases : {std::array<std::uint8_t, 2>{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
        Specimen s = test::one_diagonal_grid(1, 1, 4e-3, 4e-3);
        s.phase_names = {"quartz", "mica"};
        s.grain_phase = {phases[0], phases[1]};
        ContactLaws laws(test::augig_law());
        laws.of_class.clear();
        for (const double angle : angles) {
            ContactParameters contact = test::augig_contact();
            contact.friction_angle = angle * test::degree;
            laws.of_class.push_back(make_contact_law(contact, LawVariant::consistent));
        }
        const Assemblage a = make_assemblage(s, test::augig_granite().rock, PlaneCondition::strain);
        const auto& surface = a.surface;
        // Any node of the one grain and any edge of the other.
        const auto edge =
            std::find_if(surface.edges.begin(), surface.edges.end(), [](const SurfaceEdge& e) { return e.grain == 1; });
        const auto node = std::find(surface.grain_of_node.begin(), surface.grain_of_node.end(), 0);
        const CandidatePair pair{static_cast<std::int32_t>(node - surface.grain_of_node.begin()),
                                 static_cast<std::int32_t>(edge - surface.edges.begin())};
        const double expected = angles[contact_class(phases[0], phases[1])] * test::degree;
        EXPECT_NEAR(std::atan(friction_law(a, laws, pair).tan_friction), expected, 1e-12);
    }
}

// Grains of three phases thrown at each other without damping: what they had is stored, dissipated or still motion.
TEST(Phases, EnergyIsBalancedWithScatteredStrengths) {
    SmallRun run = test::varied_phases(test::jittered_grid(6, 10, 0.02, 0.03, 0.25)).run(LawVariant::consistent, 0.3);
    constexpr double speed = 6;  // m/s, at the ends
    run.set_velocity([&](const Vector2& x) { return Vector2{0, -speed * x.y / 0.015}; });
    run.begin();
    const double initial = run.measured().energies.kinetic;
    run.steps(1500);
    EXPECT_GT(run.failed_points(), 50U);
    const Energies last = run.measured().energies;
    EXPECT_GT(last.fracture_tension + last.fracture_shear, 0.02 * initial);
    test::verify("phases: energy balance with scattered strengths, over the initial energy",
                 (last.balance_error() + initial) / initial, 0, 2e-3, "conservation of energy", 1);
}

}  // namespace
}  // namespace graincrack
