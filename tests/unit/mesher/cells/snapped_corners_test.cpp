#include "mesher/cells/snapped_corners.hpp"

#include <gtest/gtest.h>

#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/cells/squares.hpp"

namespace graincrack::mesher {
namespace {

TEST(SnappedCorners, LieOnTheWallInItsOrder) {
    const Squares squares(8, 6);
    Region region = rectangle(8, 6);
    region.edges = {{{-2.5, 0.1}, {1.2, 0.1}, {}, "flaw"}};
    const Walls walls = walls_of(region, 1);
    const SizeField size;
    CellPieces pieces(squares.cells, walls, 1, size);
    WallChain chain = walls.chains().front();
    const ChainNodes nodes = snapped_corners(pieces, chain);
    // The nearest corners are moved to the ends, those between straight onto the line.
    ASSERT_EQ(nodes.size(), 5U);
    for (const auto& [place, p] : nodes) EXPECT_NEAR(pieces.at(p).y, 0.1, 1e-12);
    EXPECT_EQ(pieces.at(nodes.front().second), (Point{-2.5, 0.1}));
    EXPECT_EQ(pieces.at(nodes.back().second), (Point{1.2, 0.1}));
    for (std::size_t i = 1; i < nodes.size(); ++i) EXPECT_GT(nodes[i].first, nodes[i - 1].first);
    EXPECT_TRUE(pieces.is_fixed(nodes.front().second));
}

TEST(SnappedCorners, AreAddedWhereTheWallCrossesEdgesAndBehindItsEnd) {
    const Squares squares(8, 6);
    Region region = rectangle(8, 6);
    region.edges = {{{-2.5, 0.5}, {1.5, 0.5}, {}, "flaw"}};
    const Walls walls = walls_of(region, 1);
    const SizeField size;
    CellPieces pieces(squares.cells, walls, 0.5, size);  // no corner is near
    WallChain chain = walls.chains().front();
    const ChainNodes nodes = snapped_corners(pieces, chain);
    EXPECT_EQ(chain.points.front(), (Point{-3, 0.5}));
    EXPECT_EQ(chain.points.back(), (Point{2, 0.5}));
    EXPECT_EQ(chain.sides.front(), CellPieces::extension);
    ASSERT_EQ(nodes.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(pieces.at(nodes[i].second).x, -3.0 + static_cast<double>(i), 1e-12);
}

}  // namespace
}  // namespace graincrack::mesher
