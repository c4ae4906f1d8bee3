// Forces of damping by both forms.
#include "solver/law/damping.hpp"

#include <gtest/gtest.h>

namespace graincrack::test {
namespace {

struct DampedMotion {
    DampingForm form;
    Vector2 force, change, velocity;  ///< force after the step, its change in the step
    Vector2 expected;
};

// Local damping takes 0.8 of the force against the motion, and nothing at rest. The combined form does so in an oscillation,
// where F falls while v > 0 and rises while v < 0; in steady motion its halves cancel while F rises in the sense of the motion.
TEST(DampingForce, OpposesTheMotionAndInTheCombinedFormOscillationAlone) {
    constexpr auto local = DampingForm::local;
    constexpr auto combined = DampingForm::combined;
    for (const DampedMotion& row : {DampedMotion{local, {10, -5}, {3, 3}, {1, -2}, {-8, 4}},
                                    {local, {10, -5}, {3, 3}, {-1, 0}, {8, 0}},
                                    {combined, {10, -5}, {-3, 3}, {1, -2}, {-8, 4}},
                                    {combined, {10, -5}, {3, -3}, {1, -2}, {0, 0}},
                                    {combined, {10, -5}, {0, 0}, {1, 0}, {-4, 0}}}) {
        const Vector2 force = damping_force(make_damping(0.8, row.form), row.force, row.change, row.velocity);
        EXPECT_EQ(force.x, row.expected.x);
        EXPECT_EQ(force.y, row.expected.y);
    }
}

}  // namespace
}  // namespace graincrack::test
