// Who shares a vertex, and by which contact points.
#include "solver/model/vertex_clusters.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/small_run.hpp"

namespace graincrack {
namespace {

TEST(MassScaling, NoneHasNoGroups) {
    const test::SmallRun run(test::jittered_grid(3, 4, 0.02, 0.03, 0.2), test::augig_law());
    const MassScaling none = make_mass_scaling(run.assemblage, 0);
    EXPECT_FALSE(none.is_on());
    EXPECT_TRUE(none.groups.empty());
    EXPECT_TRUE(none.blocks.empty());
}

TEST(MassScaling, GroupsAreTheVerticesOfTheMesh) {
    const int nx = 9;
    const int ny = 11;
    const test::SmallRun run(test::jittered_grid(nx, ny, 0.02, 0.03, 0.2), test::augig_law());
    const Assemblage& a = run.assemblage;
    const MassScaling scaling = make_mass_scaling(a, 100);
    ASSERT_EQ(scaling.groups.size(), static_cast<std::size_t>((nx + 1) * (ny + 1)));
    ASSERT_EQ(scaling.links.size(), 2 * a.contacts.size());
    std::set<std::int32_t> seen;
    std::set<std::int32_t> points;
    std::int32_t begin = 0;
    for (std::size_t g = 0; g < scaling.groups.size(); ++g) {
        const Range members = scaling.groups[g];
        EXPECT_EQ(members.begin, begin);
        begin = members.end;
        ASSERT_GT(members.size(), 0);
        const Vector2 vertex = a.position[static_cast<std::size_t>(scaling.members[static_cast<std::size_t>(members.begin)])];
        for (std::int32_t i = members.begin; i < members.end; ++i) {
            const std::int32_t node = scaling.members[static_cast<std::size_t>(i)];
            EXPECT_TRUE(seen.insert(node).second);
            EXPECT_LT(length(a.position[static_cast<std::size_t>(node)] - vertex), 1e-12);
        }
        for (std::int32_t t = scaling.links_of_group[g].begin; t < scaling.links_of_group[g].end; ++t) {
            const MassScaling::Link& tie = scaling.links[static_cast<std::size_t>(t)];
            EXPECT_TRUE(points.insert(tie.point).second);
            for (const std::int32_t member : {tie.first, tie.second}) {
                EXPECT_GE(member, members.begin);
                EXPECT_LT(member, members.end);
            }
            const auto& nodes = a.contacts[static_cast<std::size_t>(tie.point / 2)].nodes;
            const auto end = static_cast<std::size_t>(tie.point % 2);
            EXPECT_EQ(scaling.members[static_cast<std::size_t>(tie.first)], nodes[end]);
            EXPECT_EQ(scaling.members[static_cast<std::size_t>(tie.second)], nodes[2 + end]);
        }
    }
    EXPECT_EQ(seen.size(), a.position.size());
    EXPECT_EQ(points.size(), scaling.links.size());
    // Blocks take every group once.
    std::int32_t group = 0;
    for (const Range block : scaling.blocks) {
        EXPECT_EQ(block.begin, group);
        group = block.end;
    }
    EXPECT_EQ(group, static_cast<std::int32_t>(scaling.groups.size()));
}

}  // namespace
}  // namespace graincrack
