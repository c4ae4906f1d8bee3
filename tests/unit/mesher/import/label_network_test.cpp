#include "mesher/import/label_network.hpp"

#include <gtest/gtest.h>

namespace graincrack::mesher {
namespace {

using Found = std::vector<std::size_t>;

TEST(CrowdedSegments, AreThoseThatCrossOrComeNear) {
    const std::vector<Point> points{{0, 0}, {10, 0}, {5, -3}, {5, 3}, {0, 1}, {4, 1}, {0, 5}, {40, 5.2}, {30, 4}, {30, 5}};
    const std::vector<Edge> segments{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {8, 9}};
    EXPECT_EQ(crowded_segments(points, segments, {0.3, 0.3}), (Found{0, 1, 3, 4}));
    EXPECT_EQ(crowded_segments(points, segments, {0.1, 0.3}), (Found{0, 1}));
    EXPECT_EQ(crowded_segments(points, segments, {1.01, 0.3}), (Found{0, 1, 2, 3, 4}));
    EXPECT_EQ(crowded_segments(points, {}, {1, 0.3}), Found{});
}

TEST(CrowdedSegments, AreThoseThatMeetAtASmallAngle) {
    const std::vector<Point> points{{0, 0}, {10, 0}, {10, 2}, {-10, 0.1}};
    EXPECT_EQ(crowded_segments(points, std::vector<Edge>{{0, 1}, {2, 0}, {0, 3}}, {0.3, 0.25}), (Found{0, 1}));
    EXPECT_EQ(crowded_segments(points, std::vector<Edge>{{0, 1}, {2, 0}, {0, 3}}, {0.3, 0.15}), Found{});
    EXPECT_EQ(crowded_segments(points, std::vector<Edge>{{0, 1}, {1, 0}}, {0.3, 0.15}), (Found{0, 1})) << "one lies on the other";
}

TEST(LabelNetwork, DividesTwoBoundariesBetweenTheSameJunctions) {
    // A lens of 2 between 1 and 3, whose two boundaries would both be straight.
    const LabelPieces pieces = label_pieces(read_label_image("1 1 1 1 1 1\n1 1 2 2 1 1\n3 3 2 2 3 3\n3 3 3 3 3 3\n", ""), 1, "");
    const LabelNetwork network = label_network(label_boundaries(pieces), 20);
    EXPECT_GT(network.refined_chains, 0);
    std::vector<Edge> segments;
    for (const RegionEdge& s : network.segments) segments.push_back({s.from, s.to});
    EXPECT_EQ(crowded_segments(network.points, segments, {0.3, 0.3}), Found{});
}

}  // namespace
}  // namespace graincrack::mesher
