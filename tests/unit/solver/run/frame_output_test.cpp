// Frames of states set by hand.
#include "solver/run/frame_output.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

TEST(Frame, IsInTheOrderOfTheSpecimen) {
    Specimen s = one_diagonal_grid(2, 2, 0.02, 0.02);
    const auto n = static_cast<std::int32_t>(s.n_nodes());
    std::reverse(s.node_position.begin(), s.node_position.end());
    renumber_nodes(s, [n](std::int32_t node) { return n - 1 - node; });
    SmallRun run(s, augig_law());
    for (std::size_t i = 0; i < run.state.displacement.size(); ++i) run.state.displacement[i] = 1e-5 * run.assemblage.position[i];
    run.begin();
    const Frame frame = run.frame(3);
    ASSERT_EQ(frame.displacement.size(), s.n_nodes());
    EXPECT_EQ(frame.element_stress, run.frame(1).element_stress);
    EXPECT_EQ(frame.traction, run.frame(1).traction);
    for (std::size_t i = 0; i < s.n_nodes(); ++i) {
        EXPECT_EQ(frame.displacement[i][0], 1e-5 * s.node_position[i][0]);
        EXPECT_EQ(frame.displacement[i][1], 1e-5 * s.node_position[i][1]);
    }
    // A swelling by 1e-5: the same stress in all directions, E/((1 + ν)(1 − 2ν)) · 1e-5 in plane strain, to the strain.
    const double expected = 25.8e9 / (1.23 * 0.54) * 1e-5;
    for (const auto& stress : frame.element_stress) {
        expect_close(stress[0], expected, 1e-9, expected);
        expect_close(stress[1], expected, 1e-9, expected);
        expect_close(stress[2], 0, 1e-9, expected);
        expect_close(stress[3], 2 * 0.23 * expected, 1e-9, expected);
    }
}

}  // namespace
}  // namespace graincrack::test
