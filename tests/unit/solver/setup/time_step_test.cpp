// The stable step where it has a closed form.
#include "solver/setup/stable_time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack {
namespace {

using test::expect_close;

/// One right triangle of legs 10 mm, one grain, no contacts.
Specimen triangle() { return test::specimen_of_triangles({{0, 0}, {0.01, 0}, {0, 0.01}}, {{0, 1, 2}}); }

// The value itself is compared with a dense eigenvalue in tests/physics; here: how it depends on its inputs.
TEST(StableStep, ScalesWithSizeDensityAndStiffness) {
    const auto step = [](double size, double density_factor, double modulus_factor) {
        Specimen s = triangle();
        for (auto& p : s.node_position) p = {size * p[0], size * p[1]};
        s.width *= size;
        s.height *= size;
        Rock rock = test::augig_granite().rock;
        rock.density *= density_factor;
        rock.young_modulus *= modulus_factor;
        const Assemblage a = make_assemblage(s, rock, PlaneCondition::strain);
        return stable_time_step(a, test::no_boundary(a, s), test::augig_law());
    };
    const double reference = step(1, 1, 1);
    EXPECT_GT(reference, 0.2 * 0.01 / 3359.56);  // about the time of a P wave through it
    EXPECT_LT(reference, 2 * 0.01 / 3359.56);
    expect_close(step(2, 1, 1), 2 * reference, 1e-9, reference);
    expect_close(step(1, 4, 1), 2 * reference, 1e-9, reference);
    expect_close(step(1, 1, 4), 0.5 * reference, 1e-9, reference);
}

TEST(StableStep, StiffnessHoldsRigidMotionWithoutForce) {
    const Specimen s = test::jittered_grid(3, 4, 0.02, 0.03, 0.2);
    const Assemblage a = make_assemblage(s, test::augig_granite().rock, PlaneCondition::strain);
    std::vector<Vector2> x(a.position.size());
    std::vector<Vector2> y(a.position.size());
    double stretched = 0;
    for (const int mode : {0, 1, 2, 3}) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Vector2 p = a.position[i];
            x[i] = mode == 0 ? Vector2{1, 0} : mode == 1 ? Vector2{0, 1} : mode == 2 ? Vector2{-p.y, p.x} : Vector2{p.x, 0};
        }
        apply_stiffness(a, test::no_boundary(a, s), test::augig_law(), x, y);
        double worst = 0;
        for (const Vector2& f : y) worst = std::max(worst, length(f));
        if (mode == 3) {
            stretched = worst;
        } else {
            EXPECT_LT(worst, mode < 2 ? 1e-1 : 1e-3) << mode;  // round-off of 25.8e9 · 1 resp. · 0.01
        }
    }
    EXPECT_GT(stretched, 1e6);
}

}  // namespace
}  // namespace graincrack
