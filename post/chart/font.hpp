// The font of all pictures is Liberation Sans, a listed package, so that pictures are the same on every machine. Pango takes
// missing characters from other fonts.
#pragma once

#include <cairo.h>

#include <string>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// Width of a text at a size, pixels.
double text_width(const std::string& label, double size, bool bold = false);

/// The box of a text, in pixels of the drawing: from the tops of tall letters to the bottoms of descenders.
struct TextBox {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
    [[nodiscard]] bool overlaps(const TextBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};
TextBox box_of(const Text& text);

/// Draws a text in units of pixels of the drawing.
void show_text(cairo_t* context, const Text& text);

/// Version of the library: "Pango 1.50.12".
std::string pango_library_version();

}  // namespace graincrack
