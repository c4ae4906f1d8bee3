// The history of a contact point is stored in several arrays and read as one value.
#include "solver/model/state.hpp"

#include <gtest/gtest.h>

#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

const ContactHistory slipped{.motion = {-1e-7, 3e-6},
                             .max_displacement = 2e-6,
                             .largest_open = 1.5,
                             .largest_slid = 2.5,
                             .slip = 1e-6,
                             .integrity = 0.25,
                             .friction_fraction = 0.5,
                             .bridge = 0.125,
                             .failed_closed = true,
                             .first_mode = CrackMode::shear};

TEST(PointHistory, IsReadAsItWasStoredWhileOtherPointsKeepTheirs) {
    SmallRun run(jittered_grid(3, 4, 0.02, 0.03, 0.2), augig_law());
    run.state.opening[2] = 1e-8;  // the arrays of motions are those that steps write
    const ContactHistory moved{.motion = {1e-8, 0}};
    for (const auto& [stored, is_residual] : {std::pair(slipped, true), std::pair(ContactHistory{}, false)}) {
        store_point(stored, is_residual, 3, run.state);
        EXPECT_EQ(point_history(run.state, 3), stored);
        EXPECT_EQ(run.state.failed[3], is_residual ? 1 : 0);
        EXPECT_EQ(run.state.residual[3], is_residual ? 1 : 0);
        EXPECT_EQ(point_history(run.state, 2), moved);
        EXPECT_EQ(point_history(run.state, 4), ContactHistory{});
    }
}

TEST(MakeState, BreaksNotchesAndOpenBoundariesFromTheStart) {
    Specimen s = jittered_grid(3, 4, 0.02, 0.03, 0.2);
    s.contact_kind[1] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    s.contact_kind[3] = static_cast<std::uint8_t>(ContactKind::open_boundary);
    const SmallRun run(s, augig_law());
    for_each_contact(run.assemblage, [&](std::int32_t place, std::int32_t /*contact_class*/) {
        const auto contact = run.assemblage.specimen_contact[place];
        for (const std::size_t point : points_of(place)) {
            EXPECT_EQ(point_history(run.state, point) == broken_contact(), contact == 1 || contact == 3) << contact;
            EXPECT_EQ(run.state.next_level[point] == 0, contact == 1 || contact == 3) << "no event of theirs counts";
        }
    });
}

}  // namespace
}  // namespace graincrack::test
