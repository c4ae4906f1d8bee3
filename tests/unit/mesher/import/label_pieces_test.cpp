#include "mesher/import/label_pieces.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::mesher {
namespace {

LabelPieces pieces_of(const std::string& text, int smallest_piece) {
    return label_pieces(read_label_image(text, "section"), smallest_piece, "section");
}

TEST(LabelPieces, AreConnectedBySidesOfPixels) {
    const LabelPieces p = pieces_of("7 7 3\n3 7 3\n7 3 3\n", 1);
    EXPECT_EQ(p.piece_of_pixel, (std::vector<int>{0, 0, 1, 2, 0, 1, 3, 1, 1}));
    EXPECT_EQ(p.label_of_piece, (std::vector<int>{7, 3, 3, 7}));
    EXPECT_EQ(p.pixels_of_piece, (std::vector<int>{3, 4, 1, 1}));
    EXPECT_EQ(p.joined, 0);
    EXPECT_EQ(p.labels_in_pieces, 2);
    EXPECT_EQ(p.added_by_pieces, 2);
    EXPECT_EQ(p.at(-1, 0), -1);
    EXPECT_EQ(p.at(2, 3), -1);
}

TEST(LabelPieces, JoinTheNeighbourWithTheLongestBorder) {
    const LabelPieces p = pieces_of("1 1 1 2 2\n1 1 9 2 2\n1 1 9 9 2\n1 1 2 2 2\n", 4);
    EXPECT_EQ(p.joined, 1) << "9 has three sides with 1 and five with 2";
    EXPECT_EQ(p.piece_of_pixel, (std::vector<int>{0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1}));
    EXPECT_EQ(p.label_of_piece, (std::vector<int>{1, 2}));
    EXPECT_EQ(pieces_of("1 1 1 2 2\n1 1 9 2 2\n1 1 9 9 2\n1 1 2 2 2\n", 3).size(), 3U) << "three pixels are enough";
}

TEST(LabelPieces, BecomeOneWhereThePieceBetweenThemJoins) {
    const LabelPieces p = pieces_of("1 1 5 1 1 2\n1 1 5 1 1 2\n2 2 2 2 2 2\n", 3);
    EXPECT_EQ(p.size(), 2U);
    EXPECT_EQ(p.joined, 1);
    EXPECT_EQ(p.piece_of_pixel, (std::vector<int>{0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(LabelPieces, StayWhereThereIsNoNeighbour) {
    EXPECT_EQ(pieces_of("4", 10).size(), 1U);
    const LabelPieces p = pieces_of("1 2 3 4 5", 10);
    EXPECT_EQ(p.joined, 4);
    EXPECT_EQ(p.pixels_of_piece, std::vector<int>{5});
}

TEST(LabelPieces, RefuseMoreGrainsThanAreMade) {
    LabelImage image{1001, 1000, std::vector<int>(1001000), ""};
    for (std::size_t i = 0; i < image.labels.size(); ++i) image.labels[i] = static_cast<int>(i);
    test::Refusals refused;
    refused.add<InputError>("1,001,000 labels", [&] { label_pieces(image, 1, "section"); });
    test::expect_golden(refused.text());
}

}  // namespace
}  // namespace graincrack::mesher
