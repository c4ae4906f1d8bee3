// Parts of all pages: sizes of letters, heading, legend, texts in lines; strokes and markers that stay apart in grey.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// Heights of letters and distances, in pixels of the drawing.
namespace letters {
inline constexpr double title = 30;
inline constexpr double label = 28;  ///< of axes
inline constexpr double text = 26;   ///< all else
}  // namespace letters
inline constexpr double page_margin = 28;

/// Heading of a page.
struct ChartText {
    std::string title;                    ///< bold
    std::vector<std::string> subtitle;    ///< a line each, or several where it is too long for one
    std::vector<std::string> notes = {};  ///< below the picture: what a word means, the caveats of a value
};

/// The column in which texts may stand.
struct TextColumn {
    double left = 0;
    double right = 0;
};

/// A word with a minus in place of the hyphen before a number.
std::string with_minus(std::string word);
/// A number with so many digits behind the point, without the sign of what rounds to zero.
std::string fixed_digits(double value, int digits);
/// Text in lines that are no wider than `room`, broken at ends of lines and blanks. A longer word, as names of files may be,
/// loses its middle; a hyphen before a number is a minus.
std::vector<std::string> broken_lines(const std::string& text, double size, double room, bool bold = false);

/// Draws title and subtitle from `top` downwards. \return where they end
double draw_heading(Drawing& drawing, const ChartText& text, const TextColumn& column, double top);
/// Height of what `draw_heading` draws.
double heading_height(const ChartText& text, const TextColumn& column);

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

/// A mark that stands for a curve, points or an area, and its meaning.
struct LegendEntry {
    std::variant<Stroke, Marker, Colour> mark;
    std::string label;
};
/// The ends of a legend: behind its last entry, and below all.
struct LegendEnd {
    Pixel last;  ///< right end of the baseline of the last line
    double bottom = 0;
};
inline constexpr double legend_line = 38;
/// Draws entries one after the other, in as many lines as they need. \param top of the first line
LegendEnd draw_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, const TextColumn& column, double top);

/// Drawings below one another, or side by side, on one page.
Drawing stacked(const std::vector<Drawing>& parts);
Drawing side_by_side(const std::vector<Drawing>& parts);

}  // namespace graincrack
