// How far failure involves a section: points and joints whose state is set by hand.
#include "solver/run/near_failure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

/// A contact under 10 MPa, whose failed points bear a share of the friction that they can.
void slide(SmallRun& run, std::int32_t contact, double share_of_limit) {
    const ContactLaw& law = run.parameters.laws[0];
    for (const std::size_t p : points_of(contact)) {
        run.state.failed[p] = 1;
        run.state.opening[p] = -10e6 / law.kt;
        run.state.sliding[p] = share_of_limit * 10e6 * law.tan_phi / law.ks;
        run.state.slip[p] = 0;
    }
}

// Two blocks with a level joint of four contacts over the whole width.
TEST(NearFailure, IsTheLengthOfAJointThatSlidesOverHalfTheWidth) {
    constexpr double width = 0.06;
    ThreadTeam team(2);
    SmallRun run(jointed_rectangle(4, 2, width, 0.2, 0, Blocks::of_one_grain), augig_law());
    const auto share = [&] { return near_failure(run.assemblage, run.parameters.laws[0], run.state, width, 0, team); };
    const std::vector<std::int32_t>& contacts = run.assemblage.contact_of_specimen;
    ASSERT_EQ(contacts.size(), 4U);
    for (const double friction : {0.0, 0.49, 1.0}) {  // at its limit a contact bears what it can
        for (const std::int32_t c : contacts) slide(run, c, friction);
        EXPECT_EQ(share(), 0);
    }
    // The first contact slides: a quarter of the width, over half of it.
    slide(run, contacts[0], 0.51);
    expect_close(share(), 0.5, 1e-12, 1);
    // The third is no neighbour of it, the second links them.
    slide(run, contacts[2], 0.99);
    expect_close(share(), 0.5, 1e-12, 1);
    slide(run, contacts[1], 0.99);
    EXPECT_EQ(share(), 1);
}

TEST(NearFailure, CountsAContactThatLosesItsCohesionWhileItIsOpen) {
    constexpr double width = 0.06;
    ThreadTeam team(2);
    SmallRun run(jointed_rectangle(4, 2, width, 0.2, 0, Blocks::of_one_grain), augig_law());
    ContactLaw law = run.parameters.laws[0];
    law.softens_in_shear = true;
    const std::int32_t contact = run.assemblage.contact_of_specimen[0];
    slide(run, contact, 0.9);
    for (const std::size_t p : points_of(contact)) run.state.integrity[p] = 0.5;
    EXPECT_EQ(near_failure(run.assemblage, law, run.state, width, 0, team), 0);  // friction takes over
    for (const std::size_t p : points_of(contact)) run.state.opening[p] = law.dct;
    expect_close(near_failure(run.assemblage, law, run.state, width, 0, team), 0.5, 1e-12, 1);
}

TEST(NearFailure, CountsIntactPointsOverAShareOfAll) {
    constexpr double width = 0.12;
    ThreadTeam team(2);
    SmallRun run(one_diagonal_grid(12, 12, width, width), augig_law());
    const ContactLaw& law = run.parameters.laws[0];
    const double points = 2.0 * run.assemblage.n_contacts();
    ASSERT_GT(0.06 * points, 0.5 * std::sqrt(points));
    const auto share = [&] { return near_failure(run.assemblage, law, run.state, width, 0, team); };
    const auto [first, second] = points_of(run.assemblage.contact_of_specimen[5]);
    run.state.opening[first] = 0.79 * law.dct;
    EXPECT_EQ(share(), 0);  // a quarter more is not failure yet
    run.state.opening[first] = 0.81 * law.dct;
    expect_close(share(), 1 / (0.06 * points), 1e-12, 1);
    run.state.opening[second] = 0.81 * law.dct;
    expect_close(share(), 2 / (0.06 * points), 1e-12, 1);
    std::fill(run.state.opening.begin(), run.state.opening.end(), 0.81 * law.dct);
    for (const double sliding : {0.0, 0.5, 1.0, 2.0}) {  // over what joins them to a section
        expect_close(near_failure(run.assemblage, law, run.state, width, sliding * sliding_section, team),
                     std::lerp(most_scattered, 1.0, std::min(sliding, 1.0)), 1e-12, 1);
    }
    // Few points: half a line across is more than 6 % of them.
    SmallRun few(one_diagonal_grid(2, 2, width, width), augig_law());
    few.state.opening[0] = 0.81 * law.dct;
    expect_close(near_failure(few.assemblage, law, few.state, width, sliding_section, team),
                 1 / (0.5 * std::sqrt(2.0 * few.assemblage.n_contacts())), 1e-12, 1);
}

}  // namespace
}  // namespace graincrack::test
