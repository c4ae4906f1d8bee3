// The history of a contact point is stored in several arrays and read as one value.
#include "solver/model/state.hpp"

#include <gtest/gtest.h>

#include "tests/support/small_run.hpp"

namespace graincrack {
namespace {

ContactHistory slipped_history() {
    ContactHistory h;
    h.motion = {-1e-7, 3e-6};
    h.max_displacement = 2e-6;
    h.peak_displacement = 1e-6;
    h.largest_open = 1.5;
    h.largest_slid = 2.5;
    h.slip = 1e-6;
    h.integrity = 0.25;
    h.friction_share = 0.5;
    h.failed_closed = true;
    h.first_mode = CrackMode::shear;
    return h;
}

TEST(PointHistory, IsReadAsItWasStored) {
    test::SmallRun run(test::jittered_grid(3, 4, 0.02, 0.03, 0.2), test::augig_law());
    const ContactHistory stored = slipped_history();
    store_point(stored, true, 3, run.state);
    EXPECT_EQ(point_history(run.state, 3), stored);
    EXPECT_EQ(run.state.failed[3], 1);
    EXPECT_EQ(run.state.residual[3], 1);
    store_point(ContactHistory{}, false, 3, run.state);
    EXPECT_EQ(point_history(run.state, 3), ContactHistory{});
    EXPECT_EQ(run.state.failed[3], 0);
    EXPECT_EQ(run.state.residual[3], 0);
}

TEST(PointHistory, OtherPointsKeepTheirs) {
    test::SmallRun run(test::jittered_grid(3, 4, 0.02, 0.03, 0.2), test::augig_law());
    run.state.opening[2] = 1e-8;  // the arrays of motions are those that steps write
    store_point(slipped_history(), true, 3, run.state);
    ContactHistory expected;
    expected.motion.opening = 1e-8;
    EXPECT_EQ(point_history(run.state, 2), expected);
    EXPECT_EQ(point_history(run.state, 4), ContactHistory{});
}

}  // namespace
}  // namespace graincrack
