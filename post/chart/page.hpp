// Parts of all pages: sizes of letters, heading, legend, texts in lines.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/marks.hpp"

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
/// Text in lines that are no wider than `room`, broken at ends of lines and blanks. A longer word, as names of files may be,
/// loses its middle; a hyphen before a number is a minus.
std::vector<std::string> broken_lines(const std::string& text, double size, double room, bool bold = false);

/// Draws title and subtitle from `top` downwards. \return where they end
double draw_heading(Drawing& drawing, const ChartText& text, const TextColumn& column, double top);
/// Height of what `draw_heading` draws.
double heading_height(const ChartText& text, const TextColumn& column);

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
