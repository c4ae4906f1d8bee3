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
