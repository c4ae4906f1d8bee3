#include "mesher/import/label_boundaries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace graincrack::mesher {
namespace {

LabelPieces all_pieces_of(const std::string& text) { return label_pieces(read_label_image(text, "section"), 1, "section"); }

/// The areas of the pieces by their boundaries, which are on their left or right.
std::vector<double> areas(const LabelBoundaries& boundaries, std::size_t n_pieces) {
    std::vector<double> area(n_pieces);
    for (const BoundaryChain& chain : boundaries.chains) {
        std::vector<Point> path = chain.path;  // nodes, and the corners of pixels between them
        if (!chain.closed()) {
            path.front() = boundaries.nodes[index(chain.from)];
            path.back() = boundaries.nodes[index(chain.to)];
        }
        for (std::size_t i = 0; i + (chain.closed() ? 0 : 1) < path.size(); ++i) {
            const double part = 0.5 * cross(path[i], path[(i + 1) % path.size()]);
            if (chain.left >= 0) area[index(chain.left)] += part;
            if (chain.right >= 0) area[index(chain.right)] -= part;
        }
    }
    return area;
}

TEST(LabelBoundaries, GoFromJunctionToJunction) {
    const LabelPieces pieces = all_pieces_of("1 1 2\n1 1 2\n3 3 3\n");
    const LabelBoundaries b = label_boundaries(pieces);
    EXPECT_EQ(b.nodes.size(), 4U + 3U + 1U) << "corners, ends on the outline, and where three meet";
    EXPECT_EQ(b.chains.size(), 7U + 3U);
    EXPECT_EQ(b.opened_corners, 0);
    EXPECT_EQ(areas(b, pieces.size()), (std::vector<double>{4, 2, 3}));
    const auto inner = std::count_if(b.chains.begin(), b.chains.end(), [](const BoundaryChain& c) { return !c.on_outline(); });
    EXPECT_EQ(inner, 3);
    for (const BoundaryChain& c : b.chains) EXPECT_NE(c.left, c.right);
}

TEST(LabelBoundaries, AreClosedAroundAGrain) {
    const LabelPieces pieces = all_pieces_of("1 1 1 1\n1 2 2 1\n1 1 1 1\n");
    const LabelBoundaries b = label_boundaries(pieces);
    EXPECT_EQ(b.nodes.size(), 4U);
    ASSERT_EQ(b.chains.size(), 5U);
    EXPECT_TRUE(b.chains.back().closed());
    EXPECT_EQ(b.chains.back().path.size(), 6U);
    EXPECT_EQ(areas(b, 2), (std::vector<double>{10, 2}));
}

TEST(LabelBoundaries, MeetInOneNodeOfFourPieces) {
    const LabelBoundaries b = label_boundaries(all_pieces_of("1 2\n2 1\n"));
    EXPECT_EQ(b.nodes.size(), 4U + 4U + 1U);
    EXPECT_EQ(b.opened_corners, 0);
}

/// How many nodes have a piece on more than two sides of chains.
int pinched_nodes(const LabelBoundaries& b) {
    std::map<std::pair<int, int>, int> sides;  // of a piece at a node
    for (const BoundaryChain& c : b.chains) {
        for (const int node : {c.from, c.to}) {
            if (node < 0) continue;
            for (const int piece : {c.left, c.right}) ++sides[{node, piece}];
        }
    }
    return static_cast<int>(
        std::count_if(sides.begin(), sides.end(), [](const auto& s) { return s.first.second >= 0 && s.second > 2; }));
}

TEST(LabelBoundaries, OpenTheCornerWhereAPieceMeetsItself) {
    // The ring of 1 meets itself between its last and its first pixel.
    const std::string ring = "0 0 0 0 0\n0 1 1 1 0\n0 1 2 1 0\n0 1 2 0 0\n0 1 1 2 0\n";
    for (const std::string& text : {ring, std::string("0 0 0 0 0\n0 1 1 1 0\n0 1 2 1 0\n0 1 1 2 2\n0 0 0 2 2\n"),
                                    std::string("0 0 0 0\n0 1 1 0\n0 1 0 1\n0 1 1 1\n0 0 0 0\n")}) {
        const LabelPieces pieces = all_pieces_of(text);
        const LabelBoundaries b = label_boundaries(pieces);
        EXPECT_EQ(pinched_nodes(b), 0) << text;
        const std::vector<double> area = areas(b, pieces.size());
        double sum = 0;
        for (std::size_t i = 0; i < area.size(); ++i) {
            EXPECT_NEAR(area[i], pieces.pixels_of_piece[i], 0.51) << text << i;
            sum += area[i];
        }
        EXPECT_DOUBLE_EQ(sum, static_cast<double>(pieces.piece_of_pixel.size()));
    }
    EXPECT_EQ(label_boundaries(all_pieces_of("0 0 0 0\n0 1 1 0\n0 1 0 1\n0 1 1 1\n0 0 0 0\n")).opened_corners, 1);
}

TEST(LabelJunctions, BecomeOneUnlessAPieceWouldMeetItself) {
    const LabelPieces pieces = all_pieces_of("1 1 2 2\n1 1 2 2\n1 1 4 4\n3 3 4 4\n3 3 4 4\n");
    LabelBoundaries b = label_boundaries(pieces);
    const std::size_t nodes = b.nodes.size();
    LabelBoundaries unchanged = b;
    EXPECT_EQ(join_near_junctions(unchanged, 0), 0);
    EXPECT_EQ(join_near_junctions(b, 2), 1);
    EXPECT_EQ(b.nodes.size(), nodes - 1);
    EXPECT_EQ(std::count(b.nodes.begin(), b.nodes.end(), Point{2, 2.5}), 1);
    const std::vector<double> area = areas(b, 4);
    EXPECT_DOUBLE_EQ(std::accumulate(area.begin(), area.end(), 0.0), 20);
    EXPECT_EQ(pinched_nodes(b), 0);
    // The boundary of 2 and 3 is one side long, and 1 is at both of its ends.
    LabelBoundaries pair = label_boundaries(all_pieces_of("1 1 1 1\n1 2 3 1\n1 1 1 1\n"));
    EXPECT_EQ(join_near_junctions(pair, 2), 0);
}

}  // namespace
}  // namespace graincrack::mesher
