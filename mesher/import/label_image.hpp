// Reads pictures whose pixels are grain numbers: PNG, or integers as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graincrack::mesher {

/// The labels of a picture, row by row from its top.
struct LabelImage {
    int width = 0, height = 0;
    /// Labels are the integers of a text, the greys or palette indices of a PNG, or 65536 red + 256 green + blue for colours. For
    /// transparent pixels, 255 − alpha (16 bits: 65535 − alpha) is in the bits above the last bits of that.
    std::vector<int> labels;
    std::string format;  ///< "PNG, grey, 8 bits", "text"
    /// Colours of labels that are palette indices or greys of up to 8 bits, as 65536 red + 256 green + blue.
    std::vector<int> palette = {};
    bool are_colours = false;  ///< true if labels are colours

    [[nodiscard]] int at(int column, int row) const {
        return labels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
    }
    /// The colour of a label; empty for text, 16-bit greys and transparent labels.
    [[nodiscard]] std::optional<int> colour_of(int label) const;
};

inline constexpr std::size_t most_pixels = 100'000'000;

/// Reads a picture. \param name of the file, for messages
/// \throws InputError if it is damaged, has more than `most_pixels`, or 16-bit colours; if rows of a text differ in length, or
///         it contains anything but integers ≥ 0
LabelImage read_label_image(std::string_view bytes, const std::string& name);

/// True for neither a complete PNG nor text: another kind of picture, or a part of one.
bool is_binary(std::string_view bytes);

/// True for a PNG, or a text of integers and blanks only.
bool looks_like_labels(std::string_view bytes);

}  // namespace graincrack::mesher
