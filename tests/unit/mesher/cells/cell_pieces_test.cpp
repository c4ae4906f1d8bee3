#include "mesher/cells/cell_pieces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/cells/squares.hpp"

namespace graincrack::mesher {
namespace {

struct PiecesOfSquares {
    Squares squares{4, 2};
    Walls walls = walls_of(rectangle(4, 2), 1);
    SizeField size;
    CellPieces pieces{squares.cells, walls, 1, size};
};

TEST(CellPieces, MovePointsAsFarAsTheyStaySound) {
    PiecesOfSquares made;
    const int middle = made.pieces.point_at({0, 0});
    ASSERT_GE(middle, 0);
    EXPECT_TRUE(made.pieces.is_free(middle));
    EXPECT_TRUE(made.pieces.try_move(middle, {0.3, 0.2}));
    EXPECT_FALSE(made.pieces.try_move(middle, {1.5, 0.2}));
    EXPECT_EQ(made.pieces.at(middle), (Point{0.3, 0.2}));
    EXPECT_FALSE(made.pieces.is_free(made.pieces.point_at({0, 1}))) << "lies on the outline";
    EXPECT_EQ(made.pieces.point_at({0.1, 0.1}), -1);
}

TEST(CellPieces, KeepTheMarkOfAnEdgeThatIsSplit) {
    PiecesOfSquares made;
    const int p = made.pieces.point_at({0, 0});
    const int q = made.pieces.point_at({1, 0});
    made.pieces.mark(p, q, CellPieces::extension);
    const int middle = made.pieces.add_point({0.5, 0});
    made.pieces.split_edge(p, q, middle);
    EXPECT_EQ(made.pieces.mark_of(p, middle), CellPieces::extension);
    EXPECT_EQ(made.pieces.mark_of(middle, q), CellPieces::extension);
    EXPECT_EQ(made.pieces.mark_of(p, q), CellPieces::no_wall);
    EXPECT_EQ(made.pieces.pieces_at(middle).size(), 2U);
}

TEST(CellPieces, AreInSetsBetweenBorders) {
    PiecesOfSquares made;
    for (int x = -2; x < 2; ++x) {
        const double from = x;
        made.pieces.mark(made.pieces.point_at({from, 0}), made.pieces.point_at({from + 1, 0}), CellPieces::extension);
    }
    const auto sets = made.pieces.sets([](int mark) { return mark == CellPieces::extension; });
    EXPECT_EQ(std::set<std::size_t>(sets.begin(), sets.end()).size(), 2U);
    EXPECT_EQ(sets[0], sets[3]);
    EXPECT_NE(sets[0], sets[4]);
}

}  // namespace
}  // namespace graincrack::mesher
