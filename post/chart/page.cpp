#include "post/chart/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "post/chart/font.hpp"

namespace graincrack {

namespace {

constexpr double leading = 1.32;  ///< distance of lines over the height of letters
constexpr double mark_width = 52;
constexpr double mark_gap = 14;
constexpr double entry_gap = 34;

/// A word without its middle if it is wider than `room`: file names differ at either end.
std::string shortened(const std::string& word, double size, double room, bool bold) {
    if (text_width(word, size, bold) <= room) return word;
    std::size_t keep = word.size();
    std::string shorter;
    do {
        --keep;
        std::size_t front = (keep + 1) / 2;
        std::size_t back = word.size() - keep / 2;
        const auto inside = [&word](std::size_t at) {
            return at < word.size() && (static_cast<unsigned char>(word[at]) & 0xc0U) == 0x80U;
        };
        while (front > 0 && inside(front)) --front;  // not within a multi-byte character
        while (inside(back)) ++back;
        shorter = word.substr(0, front) + "…" + word.substr(back);
    } while (keep > 1 && text_width(shorter, size, bold) > room);
    return shorter;
}

void draw_mark(Drawing& drawing, const std::variant<Stroke, Marker, Colour>& mark, Pixel at) {
    if (const auto* stroke = std::get_if<Stroke>(&mark)) {
        draw_stroke(drawing, {at, {at.x + mark_width, at.y}}, *stroke);
    } else if (const auto* marker = std::get_if<Marker>(&mark)) {
        draw_marker(drawing, {at.x + mark_width / 2, at.y}, *marker);
    } else {
        drawing.rectangle({at.x, at.y - 11}, {at.x + mark_width, at.y + 11}, std::get<Colour>(mark));
    }
}

}  // namespace

std::string fixed_digits(double value, int digits) {
    const double zero = 0.5 * std::pow(10.0, -digits);
    return with_minus(fmt::format("{:.{}f}", std::abs(value) < zero ? 0.0 : value, digits));
}

std::string with_minus(std::string word) {
    const std::size_t sign = word.find_first_not_of("([");
    const auto is_digit = [&](std::size_t at) { return at < word.size() && word[at] >= '0' && word[at] <= '9'; };
    if (sign != std::string::npos && word[sign] == '-' && is_digit(sign + 1)) word.replace(sign, 1, "−");
    return word;
}

std::vector<std::string> broken_lines(const std::string& text, double size, double room, bool bold) {
    std::vector<std::string> lines;
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        lines.emplace_back();
        std::istringstream words(paragraph);
        for (std::string next; words >> next;) {
            const std::string word = shortened(with_minus(next), size, room, bold);
            const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
            if (!lines.back().empty() && text_width(longer, size, bold) > room) {
                lines.push_back(word);
            } else {
                lines.back() = longer;
            }
        }
    }
    if (lines.empty()) lines.emplace_back();
    return lines;
}

double draw_heading(Drawing& drawing, const ChartText& text, const TextColumn& column, double top) {
    double y = top;
    const auto draw = [&](const std::string& label, double size, bool bold) {
        for (const std::string& line : broken_lines(label, size, column.right - column.left, bold)) {
            y += leading * size;
            drawing.text({{column.left, y - 0.3 * size}, line, size, palette::ink, Anchor::start, bold});
        }
    };
    if (!text.title.empty()) draw(text.title, letters::title, true);
    for (const std::string& label : text.subtitle) draw(label, letters::text, false);
    return y;
}

double heading_height(const ChartText& text, const TextColumn& column) {
    Drawing scratch(0, 0);
    return draw_heading(scratch, text, column, 0);
}

LegendEnd draw_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, const TextColumn& column, double top) {
    Pixel at{column.left, top};
    double bottom = top;
    double end = column.left;
    for (const LegendEntry& entry : entries) {
        const double room = column.right - column.left - mark_width - mark_gap;
        const auto lines = broken_lines(entry.label, letters::text, room);
        double width = 0;
        for (const std::string& line : lines) width = std::max(width, text_width(line, letters::text));
        width += mark_width + mark_gap;
        if (at.x > column.left && at.x + width > column.right) at = {column.left, bottom};
        draw_mark(drawing, entry.mark, {at.x, at.y + 0.55 * legend_line});
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double baseline = at.y + legend_line * (static_cast<double>(i) + 0.78);
            drawing.text({{at.x + mark_width + mark_gap, baseline}, lines[i], letters::text});
        }
        end = at.x + width;
        at.x = end + entry_gap;
        bottom = std::max(bottom, at.y + legend_line * static_cast<double>(lines.size()));
    }
    return {{end, bottom - 0.22 * legend_line}, bottom};
}

Drawing stacked(const std::vector<Drawing>& parts) {
    Drawing page(parts.front().width(), 0);
    for (const Drawing& part : parts) {
        page.add(part, {0, static_cast<double>(page.height())});
        page.set_height(page.height() + part.height());
    }
    return page;
}

Drawing side_by_side(const std::vector<Drawing>& parts) {
    int width = 0;
    int height = 0;
    for (const Drawing& part : parts) {
        width += part.width();
        height = std::max(height, part.height());
    }
    Drawing page(width, height);
    double x = 0;
    for (const Drawing& part : parts) {
        page.add(part, {x, 0});
        x += part.width();
    }
    return page;
}

Stroke series_stroke(std::size_t i, double width) {
    constexpr std::array<Dash, 5> dashes{Dash::none, Dash::dashed, Dash::dash_dot, Dash::long_dashed, Dash::dotted};
    const Dash dash = dashes[i % dashes.size()];
    return {palette::series(i), dash == Dash::dotted ? 1.4 * width : width, dash};  // dots are faint
}

MarkerShape marker_shape(std::size_t i) {
    constexpr std::array<MarkerShape, 5> shapes{MarkerShape::disc, MarkerShape::square, MarkerShape::triangle, MarkerShape::cross,
                                                MarkerShape::diamond};
    return shapes[i % shapes.size()];
}

void draw_stroke(Drawing& drawing, std::vector<Pixel> points, const Stroke& stroke) {
    if (points.size() > 1) drawing.polyline(std::move(points), stroke.width, stroke.colour, stroke.dash);
}

namespace {

/// Corners of a closed shape in half sizes; a disc has many.
std::vector<std::array<double, 2>> corners(MarkerShape shape) {
    switch (shape) {
        case MarkerShape::square: return {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}};
        case MarkerShape::triangle: return {{0, -1.2}, {1.1, 0.8}, {-1.1, 0.8}};
        case MarkerShape::diamond: return {{0, -1.2}, {1.2, 0}, {0, 1.2}, {-1.2, 0}};
        case MarkerShape::leaves: return {{-1.2, 0}, {0.8, -1.1}, {0.8, 1.1}};
        case MarkerShape::disc:
        case MarkerShape::cross: break;
    }
    std::vector<std::array<double, 2>> circle;
    constexpr int n = 36;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        circle.push_back({std::cos(angle), std::sin(angle)});
    }
    return circle;
}

}  // namespace

void draw_marker(Drawing& drawing, Pixel at, const Marker& marker) {
    const double r = marker.size / 2;
    const auto moved = [&](std::array<double, 2> p) { return Pixel{at.x + p[0] * r, at.y + p[1] * r}; };
    if (marker.shape == MarkerShape::cross) {
        drawing.line(moved({-1, -1}), moved({1, 1}), 0.3 * marker.size, marker.colour);
        drawing.line(moved({-1, 1}), moved({1, -1}), 0.3 * marker.size, marker.colour);
        return;
    }
    if (marker.shape == MarkerShape::disc && !marker.hollow) return drawing.polyline({at, at}, marker.size, marker.colour);
    std::vector<Pixel> outline;
    for (const auto& corner : corners(marker.shape)) outline.push_back(moved(corner));
    if (!marker.hollow) return drawing.polygon(outline, marker.colour);
    outline.push_back(outline.front());
    drawing.polyline(outline, 0.15 * marker.size, marker.colour);
}

}  // namespace graincrack
