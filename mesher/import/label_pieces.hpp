// Divides the pixels of a picture into connected pieces; pieces too small for a grain join a neighbour.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesher/import/label_image.hpp"

namespace graincrack::mesher {

/// The pieces of a picture, each connected by sides of pixels, numbered in the order of their first pixels, row by row from the
/// top.
struct LabelPieces {
    int width = 0, height = 0;
    std::vector<int> piece_of_pixel;
    std::vector<int> label_of_piece;
    std::vector<int> pixels_of_piece;
    int joined = 0;            ///< number of pieces that were too small
    int labels_in_pieces = 0;  ///< number of labels with several pieces
    int added_by_pieces = 0;   ///< number of pieces beyond one per label

    [[nodiscard]] std::size_t size() const { return label_of_piece.size(); }
    /// The piece of a pixel; −1 outside of the picture.
    [[nodiscard]] int at(int column, int row) const {
        if (column < 0 || row < 0 || column >= width || row >= height) return -1;
        return piece_of_pixel[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
    }
};

inline constexpr std::size_t most_grains = 1'000'000;

/// Divides a picture into pieces of one label. Pieces of fewer than `smallest_piece` pixels join the neighbour with which they
/// share most sides of pixels, the smallest piece first; of several such neighbours the larger, then the first in the picture.
/// \throws InputError for a photo, most of whose pixels lie in such small pieces; also if more than `most_grains` pieces are
/// left, or ten times as many exist at first
LabelPieces label_pieces(const LabelImage& image, int smallest_piece, const std::string& name);

}  // namespace graincrack::mesher
