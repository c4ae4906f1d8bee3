// The font of all pictures: Liberation Sans, which the package list has, so that a picture is the same on every machine.
// Characters that it lacks come from other fonts (Pango).
#pragma once

#include <cairo.h>

#include <string>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// Width of a text set in a size, in pixels.
double text_width(const std::string& label, double size, bool bold = false);

/// Draws a text, whose unit is the pixel of the drawing.
void show_text(cairo_t* context, const Text& text);

/// "Pango 1.50.12".
std::string pango_library_version();

}  // namespace graincrack
