// Pictures whose pixels hold the number of their grain: PNG, or integers as text.
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
    /// Of text, the integer; of a PNG of greys, the grey; of a palette, the index. Of colours, 65536 red + 256 green + blue. Of
    /// what is not opaque, the last bits of that with 255 − alpha (65535 − alpha of 16 bits) in the bits above.
    std::vector<int> labels;
    std::string format;  ///< "PNG, grey, 8 bits", "text"
    /// The colours of labels that are numbers of a palette or greys of up to 8 bits, as 65536 red + 256 green + blue.
    std::vector<int> palette = {};
    bool are_colours = false;  ///< whether labels are colours themselves

    [[nodiscard]] int at(int column, int row) const {
        return labels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
    }
    /// The colour that a label is shown in; none of text, of greys of 16 bits and of what is not opaque.
    [[nodiscard]] std::optional<int> colour_of(int label) const;
};

inline constexpr std::size_t most_pixels = 100'000'000;

/// Reads a picture. \param name of the file, for messages
/// \throws InputError if it is damaged, of more than `most_pixels`, or of colours of 16 bits; if rows of the text differ in
///         length, or anything in it is no integer from 0
LabelImage read_label_image(std::string_view bytes, const std::string& name);

/// Whether these are neither a whole PNG nor text: another picture, or a part of one.
bool is_binary(std::string_view bytes);

/// Whether these are the bytes of a PNG, or a text of nothing but integers and blanks.
bool looks_like_labels(std::string_view bytes);

}  // namespace graincrack::mesher
