// Who shares a vertex.
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
    EXPECT_TRUE(none.clusters.empty());
    EXPECT_TRUE(none.chunks.empty());
}

TEST(MassScaling, ClustersAreTheVerticesOfTheMesh) {
    const int nx = 9;
    const int ny = 11;
    const test::SmallRun run(test::jittered_grid(nx, ny, 0.02, 0.03, 0.2), test::augig_law());
    const Assemblage& a = run.assemblage;
    const MassScaling scaling = make_mass_scaling(a, 100);
    ASSERT_EQ(scaling.clusters.size(), static_cast<std::size_t>((nx + 1) * (ny + 1)));
    ASSERT_EQ(scaling.cluster_mass.size(), scaling.clusters.size());
    std::set<std::int32_t> seen;
    std::int32_t begin = 0;
    for (std::size_t g = 0; g < scaling.clusters.size(); ++g) {
        const Range places = scaling.clusters[g];
        EXPECT_EQ(places.begin, begin);
        begin = places.end;
        ASSERT_GT(places.size(), 0);
        const Vector2 vertex = a.position[static_cast<std::size_t>(scaling.nodes[static_cast<std::size_t>(places.begin)])];
        double mass = 0;
        for (std::int32_t i = places.begin; i < places.end; ++i) {
            const std::int32_t node = scaling.nodes[static_cast<std::size_t>(i)];
            EXPECT_TRUE(seen.insert(node).second);
            EXPECT_LT(length(a.position[static_cast<std::size_t>(node)] - vertex), 1e-12);
            EXPECT_EQ(scaling.cluster_of_node[static_cast<std::size_t>(node)], static_cast<std::int32_t>(g));
            mass += a.mass[static_cast<std::size_t>(node)];
        }
        EXPECT_NEAR(scaling.cluster_mass[g], mass, 1e-15 * mass);
    }
    EXPECT_EQ(seen.size(), a.position.size());
    for (const ContactGeometry& g : a.contacts) {
        for (std::size_t p = 0; p < 2; ++p) {
            EXPECT_EQ(scaling.cluster_of_node[static_cast<std::size_t>(g.nodes[p])],
                      scaling.cluster_of_node[static_cast<std::size_t>(g.nodes[2 + p])]);
        }
    }
    // Chunks take every cluster once.
    std::int32_t cluster = 0;
    for (const Range chunk : scaling.chunks) {
        EXPECT_EQ(chunk.begin, cluster);
        cluster = chunk.end;
    }
    EXPECT_EQ(cluster, static_cast<std::int32_t>(scaling.clusters.size()));
}

}  // namespace
}  // namespace graincrack
