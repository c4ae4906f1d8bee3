// How curves and points are drawn: strokes, markers, and the series of them that stay apart in grey.
#pragma once

#include <cstddef>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

struct Stroke {
    Colour colour = palette::ink;
    double width = 4;
    Dash dash = Dash::none;
};
/// The i-th curve of a plot: another colour and another dash for every i.
Stroke series_stroke(std::size_t i, double width = 4);

/// `leaves` points to the left: what goes on beyond the frame.
enum class MarkerShape { disc, square, triangle, cross, diamond, leaves };
struct Marker {
    Colour colour = palette::ink;
    MarkerShape shape = MarkerShape::disc;
    double size = 15;
    bool hollow = false;  ///< its outline alone, so that markers at one place can all be seen
};
/// Another shape for every i, so that series stay apart without colour.
MarkerShape marker_shape(std::size_t i);

void draw_stroke(Drawing& drawing, std::vector<Pixel> points, const Stroke& stroke);
void draw_marker(Drawing& drawing, Pixel at, const Marker& marker);

}  // namespace graincrack
