// The texts and lines of a drawing.
#pragma once

#include <optional>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack::test {

/// Its texts that are not empty.
inline std::vector<Text> texts_of(const Drawing& drawing) {
    std::vector<Text> texts;
    for (const Drawing::Shape& shape : drawing.shapes()) {
        const auto* text = std::get_if<Text>(&shape);
        if (text != nullptr && !text->label.empty()) texts.push_back(*text);
    }
    return texts;
}

/// Its lines of one colour, and of one width if that is given.
inline std::vector<Polyline> lines_of(const Drawing& drawing, Colour colour, std::optional<double> width = std::nullopt) {
    std::vector<Polyline> lines;
    for (const Drawing::Shape& shape : drawing.shapes()) {
        const auto* line = std::get_if<Polyline>(&shape);
        if (line != nullptr && line->colour == colour && line->width == width.value_or(line->width)) lines.push_back(*line);
    }
    return lines;
}

}  // namespace graincrack::test
