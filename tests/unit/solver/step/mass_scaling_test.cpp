// Who shares a vertex.
#include "solver/step/mass_scaling.hpp"
#include "solver/model/vertex_clusters.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

TEST(MassScaling, TakesTheVerticesOfTheMeshForClusters) {
    const int nx = 9;
    const int ny = 11;
    const SmallRun run(jittered_grid(nx, ny, 0.02, 0.03, 0.2), augig_law());
    const Assemblage& a = run.assemblage;
    const MassScaling scaling = make_mass_scaling(a, 100);
    ASSERT_EQ(a.n_clusters(), (nx + 1) * (ny + 1));
    ASSERT_EQ(scaling.cluster_mass.size(), static_cast<std::size_t>(a.n_clusters()));
    std::set<std::int32_t> seen;
    std::int32_t next_cluster = 0;
    std::int32_t next_node = 0;
    for (const NodeChunk& chunk : a.node_chunks) {
        EXPECT_EQ(chunk.clusters.begin, next_cluster);
        EXPECT_LE(chunk.clusters.size(), clusters_per_chunk);
        EXPECT_EQ(chunk.nodes.begin, next_node);
        EXPECT_LE(chunk.nodes.size(), nodes_per_chunk);
        for (std::int32_t cluster = chunk.clusters.begin; cluster < chunk.clusters.end; ++cluster) {
            const Vector2 vertex = a.position[chunk.nodes.begin + cluster - chunk.clusters.begin];
            double mass = 0;
            for_each_node_of(a, chunk, cluster, [&](std::int32_t node) {
                EXPECT_TRUE(node >= chunk.nodes.begin && node < chunk.nodes.end);
                EXPECT_TRUE(seen.insert(node).second);
                EXPECT_LT(length(a.position[node] - vertex), 1e-12);
                EXPECT_EQ(a.cluster_of_node[node], cluster);
                mass += a.mass[node];
            });
            EXPECT_NEAR(scaling.cluster_mass[cluster], mass, 1e-15 * mass);
        }
        next_cluster = chunk.clusters.end;
        next_node = chunk.nodes.end;
    }
    EXPECT_EQ(next_cluster, a.n_clusters());
    EXPECT_EQ(next_node, a.n_nodes());
    EXPECT_EQ(seen.size(), a.position.size());
    for (const ContactGeometry& g : a.contacts) {
        for (std::size_t p = 0; p < 2; ++p) {
            EXPECT_EQ(a.cluster_of_node[g.nodes[p]], a.cluster_of_node[g.nodes[2 + p]]);
        }
    }
}

}  // namespace
}  // namespace graincrack::test
