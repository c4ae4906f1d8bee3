#include "mesher/cells/joined_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/cells/squares.hpp"

namespace graincrack::mesher {
namespace {

/// Pieces that are left, with the sum of their areas.
std::pair<int, double> left_of_pieces(const CellPieces& pieces) {
    std::pair<int, double> left{0, 0};
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        if (pieces.loop(piece).empty()) continue;
        ++left.first;
        left.second += pieces.area(piece);
    }
    return left;
}

TEST(JoinedPieces, AreAsManyAsSeeds) {
    const Squares squares(4, 2);
    const Walls walls = walls_of(rectangle(4, 2), 1);
    const SizeField size;
    CellPieces pieces(squares.cells, walls, 1, size);
    // The first square in two pieces, of which the smaller joins a neighbour.
    const PieceLoop loop = pieces.loop(0);
    const int low = pieces.add_point({-1.1, -1});
    pieces.split_edge(loop[0], loop[1], low);
    pieces.set_loop(0, {loop[0], low, loop[2], loop[3]});
    pieces.add_piece({low, loop[1], loop[2]}, 0);
    Point no_room;
    const auto wanted = joined_pieces(pieces, squares.seeds, squares.areas, no_room);
    ASSERT_TRUE(wanted);
    EXPECT_EQ(left_of_pieces(pieces).first, 8);
    EXPECT_NEAR(left_of_pieces(pieces).second, 8, 1e-12);
    EXPECT_NEAR(std::accumulate(wanted->begin(), wanted->end(), 0.0), 8, 1e-12);
}

TEST(JoinedPieces, AreHalvedWhereSeedsAreMore) {
    const Squares squares(4, 2);
    const Walls walls = walls_of(rectangle(4, 2), 1);
    const SizeField size;
    CellPieces pieces(squares.cells, walls, 1, size);
    const PieceLoop first = pieces.loop(0);
    const PieceLoop second = pieces.loop(1);
    pieces.set_loop(0, {first[0], first[1], second[1], second[2], first[2], first[3]});
    pieces.set_loop(1, {});
    Point no_room;
    const auto wanted = joined_pieces(pieces, squares.seeds, squares.areas, no_room);
    ASSERT_TRUE(wanted);
    EXPECT_EQ(left_of_pieces(pieces).first, 8);
    EXPECT_NEAR(left_of_pieces(pieces).second, 8, 1e-12);
}

}  // namespace
}  // namespace graincrack::mesher
