// Parts of all pages: letter sizes, heading, legend, broken lines; strokes and markers that can be distinguished in grey.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// Letter heights and distances in pixels of the drawing.
namespace letters {
inline constexpr double title = 30;
inline constexpr double label = 28;  ///< labels of axes
inline constexpr double text = 26;   ///< all other text
}  // namespace letters
inline constexpr double page_margin = 28;

/// Heading and notes of a page.
struct ChartText {
    std::string title;                    ///< bold
    std::vector<std::string> subtitle;    ///< one line each, or several for a long one
    std::vector<std::string> notes = {};  ///< below the picture: definitions and caveats
};

/// The horizontal range of texts, pixels.
struct TextColumn {
    double left = 0;
    double right = 0;
};

/// A word with a minus sign in place of a hyphen before a number.
std::string with_minus(std::string word);
/// A number with a fixed number of decimals, without the sign of a rounded zero.
std::string fixed_digits(double value, int digits);
/// Text in lines not wider than `room` (pixels), broken at line ends and blanks. A longer word, such as a file name, loses its
/// middle; a hyphen before a number becomes a minus.
std::vector<std::string> broken_lines(const std::string& text, double size, double room, bool bold = false);

/// Draws title and subtitle from `top` downwards. \return their bottom, pixels
double draw_heading(Drawing& drawing, const ChartText& text, const TextColumn& column, double top);
/// Height of the heading drawn by `draw_heading`.
double heading_height(const ChartText& text, const TextColumn& column);

struct Stroke {
    Colour colour = palette::ink;
    double width = 4;
    Dash dash = Dash::none;
};
/// Stroke of curve i of a plot, with its own colour and dash.
Stroke series_stroke(std::size_t i, double width = 4);

/// Shapes of markers; `leaves` points left and marks a curve that continues beyond the frame.
enum class MarkerShape { disc, square, triangle, cross, diamond, leaves };
struct Marker {
    Colour colour = palette::ink;
    MarkerShape shape = MarkerShape::disc;
    double size = 15;
    bool hollow = false;  ///< outline only, so that markers at one place are all visible
};
/// Shape of series i, which distinguishes series without colour.
MarkerShape marker_shape(std::size_t i);

void draw_stroke(Drawing& drawing, std::vector<Pixel> points, const Stroke& stroke);
void draw_marker(Drawing& drawing, Pixel at, const Marker& marker);

/// A mark for a curve, points or an area, and its meaning.
struct LegendEntry {
    std::variant<Stroke, Marker, Colour> mark;
    std::string label;
};
/// The ends of a legend: after its last entry, and below it.
struct LegendEnd {
    Pixel last;  ///< right end of the baseline of the last line
    double bottom = 0;
};
inline constexpr double legend_line = 38;
/// Draws entries in sequence, in as many lines as they need. \param top of the first line, pixels
LegendEnd draw_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, const TextColumn& column, double top);

/// Combines drawings below one another, or side by side, on one page.
Drawing stacked(const std::vector<Drawing>& parts);
Drawing side_by_side(const std::vector<Drawing>& parts);

}  // namespace graincrack
