// The font of all pictures: Liberation Sans, which the package list has, so that a picture is the same on every machine.
// Characters that it lacks come from other fonts (Pango).
#pragma once

#include <cairo.h>

#include <string>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// Width of a text set in a size, in pixels.
double text_width(const std::string& label, double size, bool bold = false);

/// The box of a text, in pixels of the drawing: from the tops of capitals and high letters to the feet of low ones.
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

/// Draws a text, whose unit is the pixel of the drawing.
void show_text(cairo_t* context, const Text& text);

/// "Pango 1.50.12".
std::string pango_library_version();

}  // namespace graincrack
