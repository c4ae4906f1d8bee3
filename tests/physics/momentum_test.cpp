// Momentum and angular momentum of a specimen without supports that breaks apart while it spins: conserved to round-off.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

/// Turn of the specimen's first grain, from an edge of its first element.
double turn(const SmallRun& run) {
    const auto [n0, n1, n2] = run.assemblage.element_nodes[0];
    const Vector2 before = run.assemblage.position[n1] - run.assemblage.position[n0];
    const Vector2 after = before + run.state.displacement[n1] - run.state.displacement[n0];
    return std::abs(std::atan2(before.x * after.y - before.y * after.x, dot(before, after)));
}

// Internal forces come in pairs and couples, so that both momenta are conserved to round-off, for every law.
TEST(Momentum, IsKeptWhileContactsFailAndEverythingTurns) {
    for (const ContactLaw& law : every_law(augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i))) {
        SmallRun run(jittered_grid(4, 6, 0.02, 0.03, 0.2), law);
        SCOPED_TRACE(name_of(law.variant));
        // Drift, spin, a pull along y and a shear: cracks of both modes.
        run.set_velocity([](const Vector2& p) { return Vector2{3 - 2000 * p.y + 400 * p.y, -1 + 2000 * p.x + 300 * p.y}; });
        run.begin();
        const Momenta before = momenta_of(run);
        double largest_turn = 0, forces = 0;
        for (int i = 0; i < 100; ++i) {
            run.steps(100);
            const Momenta now = momenta_of(run);
            verify("dynamics: momentum while it cracks and turns, drift over sum |p|", length(now.linear - before.linear), 0,
                   1e-12, "conserved", before.linear_scale);
            verify("dynamics: angular momentum while it cracks and turns, drift over sum |x||p|", now.angular, before.angular,
                   1e-12, "conserved", before.angular_scale);
            largest_turn = std::max(largest_turn, turn(run));
            forces = std::max(forces, run.measured().unbalanced_ratio);
        }
        EXPECT_GT(largest_turn, 0.5);         // rad
        EXPECT_GT(forces, 0.01);              // nodal forces are not zero
        EXPECT_GT(run.failed_points(), 10U);  // it cracked
        EXPECT_GT(std::abs(before.angular), 0.1 * before.angular_scale);
    }
}

}  // namespace
}  // namespace graincrack::test
