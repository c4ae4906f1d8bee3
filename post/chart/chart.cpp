#include "post/chart/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "post/chart/font.hpp"
#include "share/units.hpp"

namespace graincrack {

namespace {

constexpr double page_width = 1000;
constexpr double left_margin = 145;
constexpr double right_margin = 40;
constexpr double right_margin_with_axis = 130;
constexpr double top_margin = 30;
constexpr double plot_height = 600;
constexpr double title_size = 31;
constexpr double subtitle_size = 25;
constexpr double label_size = 30;
constexpr double tick_size = 27;
constexpr double name_size = 23;
constexpr double legend_size = 26;
constexpr double legend_line = 40;
constexpr double legend_mark = 52;
constexpr double dash = 16;

std::string tick_text(double tick) { return format_number(std::abs(tick) < 1e-12 ? 0.0 : tick, 6); }

double text_end(double top, const ChartText& text) {
    return top + (text.title.empty() ? 0 : 1.35 * title_size) + 1.35 * subtitle_size * static_cast<double>(text.subtitle.size());
}

std::vector<double> ticks_of(const Axis& axis, int wanted) {
    if (!axis.logarithmic) return round_ticks(axis.low, axis.high, wanted);
    if (axis.high < 3 * axis.low) return round_ticks(axis.low, axis.high, wanted);
    const std::vector<double> factors =
        axis.high < 30 * axis.low ? std::vector<double>{1, 1.5, 2, 3, 4, 5, 6, 8} : std::vector<double>{1, 2, 5};
    std::vector<double> ticks;
    for (double decade = std::pow(10, std::floor(std::log10(axis.low))); decade <= axis.high; decade *= 10) {
        for (double factor : factors) {
            const double tick = factor * decade;
            if (tick >= axis.low * (1 - 1e-9) && tick <= axis.high * (1 + 1e-9)) ticks.push_back(tick);
        }
    }
    return ticks;
}

/// A word with its middle left out if it is wider than `room`, as names of files may be: they differ at either end.
std::string shortened(std::string word, double size, double room) {
    if (text_width(word, size) <= room) return word;
    std::size_t keep = word.size();
    std::string shorter;
    do {
        --keep;
        std::size_t front = (keep + 1) / 2;
        std::size_t back = word.size() - keep / 2;
        const auto inside = [&word](std::size_t at) {
            return at < word.size() && (static_cast<unsigned char>(word[at]) & 0xc0U) == 0x80U;
        };
        while (front > 0 && inside(front)) --front;  // not within a character
        while (inside(back)) ++back;
        shorter = word.substr(0, front) + "…" + word.substr(back);
    } while (keep > 1 && text_width(shorter, size) > room);
    return shorter;
}

/// Text in lines that are no wider than `room`, broken at blanks.
std::vector<std::string> broken_lines(const std::string& text, double size, double room) {
    std::vector<std::string> lines(1);
    std::istringstream in(text);
    for (std::string next; in >> next;) {
        const std::string word = shortened(next, size, room);
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (!lines.back().empty() && text_width(longer, size) > room) {
            lines.push_back(word);
        } else {
            lines.back() = longer;
        }
    }
    return lines;
}

/// Part of a segment inside a box (Liang & Barsky); false if none.
bool clip(Pixel& a, Pixel& b, Pixel low, Pixel high) {
    double first = 0;
    double last = 1;
    const Pixel d{b.x - a.x, b.y - a.y};
    const auto cut = [&](double step, double room) {
        if (step == 0) return room >= 0;
        const double share = room / step;
        if (step < 0) first = std::max(first, share);
        if (step > 0) last = std::min(last, share);
        return first <= last;
    };
    if (!cut(-d.x, a.x - low.x) || !cut(d.x, high.x - a.x) || !cut(-d.y, a.y - low.y) || !cut(d.y, high.y - a.y)) return false;
    b = {a.x + last * d.x, a.y + last * d.y};
    a = {a.x + first * d.x, a.y + first * d.y};
    return true;
}

/// A line as it is drawn: steps too small to be seen are left out, its end is not.
class LineInHand {
public:
    [[nodiscard]] bool goes_on_at(Pixel from) const { return !end_ || std::hypot(end_->x - from.x, end_->y - from.y) < 0.01; }
    void add(Pixel from, Pixel to) {
        if (!end_) points_.push_back(from);
        if (std::hypot(points_.back().x - to.x, points_.back().y - to.y) > 0.3) points_.push_back(to);
        end_ = to;
    }
    std::vector<Pixel> finish() {
        if (end_ && (points_.back().x != end_->x || points_.back().y != end_->y)) points_.push_back(*end_);
        return std::move(points_);
    }

private:
    std::vector<Pixel> points_;
    std::optional<Pixel> end_;
};

}  // namespace

MarkerShape marker_shape(std::size_t i) {
    constexpr std::array<MarkerShape, 4> shapes{MarkerShape::disc, MarkerShape::square, MarkerShape::triangle,
                                                MarkerShape::cross};
    return shapes[i % shapes.size()];
}

std::pair<double, double> padded_range(std::span<const double> values, double pad) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!(low <= high)) return {0, 1};
    const double room = high > low ? pad * (high - low) : std::max(pad * std::abs(high), 1e-12);
    return {low - room, high + room};
}

double Chart::Scale::operator()(double value) const {
    const auto share = [&](double v) {
        if (!axis.logarithmic) return (v - axis.low) / (axis.high - axis.low);
        return std::log(v / axis.low) / std::log(axis.high / axis.low);
    };
    return from + share(value) * (to - from);
}

Chart::Chart(const ChartText& text, const Axis& x, const Axis& y, const std::optional<Axis>& right, bool equal_scales)
    : drawing_(static_cast<int>(page_width), 100) {
    const double top = text_end(top_margin, text) + 20;
    const double width = page_width - left_margin - (right ? right_margin_with_axis : right_margin);
    const double height = equal_scales ? width * (y.high - y.low) / (x.high - x.low) : plot_height;
    x_ = {x, left_margin, left_margin + width};
    y_ = {y, top + height, top};
    if (right) right_ = Scale{*right, y_.from, y_.to};
    double line = top_margin;
    if (!text.title.empty()) {
        line += 1.35 * title_size;
        drawing_.text({{left_margin - 105, line - 10}, text.title, title_size, palette::ink, Anchor::start, true});
    }
    for (const std::string& label : text.subtitle) {
        line += 1.35 * subtitle_size;
        drawing_.text({{left_margin - 105, line - 8}, label, subtitle_size});
    }
    draw_grid();
}

void Chart::draw_grid() {
    for (const double tick : ticks_of(x_.axis, 7)) drawing_.line({x_(tick), y_.from}, {x_(tick), y_.to}, 1, palette::faint);
    for (const double tick : ticks_of(y_.axis, 6)) drawing_.line({x_.from, y_(tick)}, {x_.to, y_(tick)}, 1, palette::faint);
    const auto crossed = [](const Axis& axis) { return !axis.logarithmic && axis.low < 0 && axis.high > 0; };
    if (crossed(x_.axis)) drawing_.line({x_(0), y_.from}, {x_(0), y_.to}, 1.6, palette::rim);
    if (crossed(y_.axis)) drawing_.line({x_.from, y_(0)}, {x_.to, y_(0)}, 1.6, palette::rim);
}

void Chart::line(std::span<const double> x, std::span<const double> y, const Stroke& stroke, Side side) {
    const Scale& scale = side == Side::right && right_ ? *right_ : y_;
    LineInHand hand;
    const auto finish = [&] {
        stroke_line(hand.finish(), stroke);
        hand = {};
    };
    for (std::size_t i = 1; i < x.size(); ++i) {
        Pixel from{x_(x[i - 1]), scale(y[i - 1])};
        Pixel to{x_(x[i]), scale(y[i])};
        const bool finite = std::isfinite(from.x) && std::isfinite(from.y) && std::isfinite(to.x) && std::isfinite(to.y);
        if (!finite || !clip(from, to, {x_.from, y_.to}, {x_.to, y_.from})) {
            finish();
            continue;
        }
        if (!hand.goes_on_at(from)) finish();
        hand.add(from, to);
    }
    finish();
}

void Chart::stroke_line(const std::vector<Pixel>& points, const Stroke& stroke) {
    if (points.size() < 2) return;
    if (!stroke.dashed) {
        drawing_.polyline(points, stroke.width, stroke.colour);
        return;
    }
    std::vector<Pixel> piece{points.front()};
    double left = dash;
    bool on = true;
    for (std::size_t i = 1; i < points.size(); ++i) {
        Pixel from = points[i - 1];
        double length = std::hypot(points[i].x - from.x, points[i].y - from.y);
        while (length > left) {
            const double share = left / length;
            from = {from.x + share * (points[i].x - from.x), from.y + share * (points[i].y - from.y)};
            length -= left;
            piece.push_back(from);
            if (on) drawing_.polyline(piece, stroke.width, stroke.colour);
            piece = {from};
            on = !on;
            left = on ? dash : 0.8 * dash;
        }
        left -= length;
        piece.push_back(points[i]);
    }
    if (on && piece.size() > 1) drawing_.polyline(piece, stroke.width, stroke.colour);
}

void Chart::draw_marker(Pixel at, const Marker& marker) {
    const double r = marker.size / 2;
    switch (marker.shape) {
        case MarkerShape::disc: drawing_.polyline({at, at}, marker.size, marker.colour); break;
        case MarkerShape::square:
            drawing_.rectangle({at.x - 0.9 * r, at.y - 0.9 * r}, {at.x + 0.9 * r, at.y + 0.9 * r}, marker.colour);
            break;
        case MarkerShape::triangle:
            drawing_.polygon({{at.x, at.y - 1.2 * r}, {at.x + 1.1 * r, at.y + 0.8 * r}, {at.x - 1.1 * r, at.y + 0.8 * r}},
                             marker.colour);
            break;
        case MarkerShape::cross:
            drawing_.line({at.x - r, at.y - r}, {at.x + r, at.y + r}, 0.3 * marker.size, marker.colour);
            drawing_.line({at.x - r, at.y + r}, {at.x + r, at.y - r}, 0.3 * marker.size, marker.colour);
            break;
    }
}

void Chart::points(std::span<const double> x, std::span<const double> y, const Marker& marker) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Pixel at = place(x[i], y[i]);
        const bool inside = at.x >= x_.from - 1 && at.x <= x_.to + 1 && at.y >= y_.to - 1 && at.y <= y_.from + 1;
        if (inside) draw_marker(at, marker);
    }
}

void Chart::error_bar(double x, double low, double high, Colour colour) {
    constexpr double cap = 9;
    const double bottom = std::clamp(y_(low), y_.to, y_.from);
    const double top = std::clamp(y_(high), y_.to, y_.from);
    drawing_.line({x_(x), bottom}, {x_(x), top}, 2.5, colour);
    for (const double y : {bottom, top}) drawing_.line({x_(x) - cap, y}, {x_(x) + cap, y}, 2.5, colour);
}

void Chart::band(std::span<const double> x, std::span<const double> low, std::span<const double> high, Colour colour) {
    const auto inside = [&](double value) { return std::clamp(y_(value), y_.to, y_.from); };
    for (std::size_t i = 1; i < x.size(); ++i) {
        drawing_.polygon({{x_(x[i - 1]), inside(low[i - 1])},
                          {x_(x[i]), inside(low[i])},
                          {x_(x[i]), inside(high[i])},
                          {x_(x[i - 1]), inside(high[i - 1])}},
                         colour);
    }
}

void Chart::box(double x_low, double x_high, double y_low, double y_high, Colour colour) {
    const auto across = [&](double value) { return std::clamp(x_(value), x_.from, x_.to); };
    const auto up = [&](double value) { return std::clamp(y_(value), y_.to, y_.from); };
    drawing_.rectangle({across(x_low), up(y_high)}, {across(x_high), up(y_low)}, colour);
}

void Chart::note(double x, double y, const std::string& label, Colour colour, Anchor anchor) {
    const Pixel at = place(x, y);
    const double shift = anchor == Anchor::start ? 12 : anchor == Anchor::end ? -12 : 0;
    drawing_.text({{at.x + shift, at.y - 8}, label, subtitle_size, colour, anchor});
}

void Chart::legend(const Stroke& stroke, const std::string& label) { legend_.push_back({stroke, std::nullopt, {}, label}); }
void Chart::legend(const Marker& marker, const std::string& label) { legend_.push_back({std::nullopt, marker, {}, label}); }
void Chart::legend_area(Colour colour, const std::string& label) {
    legend_.push_back({std::nullopt, std::nullopt, colour, label});
}

void Chart::draw_ticks() {
    std::vector<std::pair<double, std::string>> ticks;
    if (named_ticks_) {
        ticks = *named_ticks_;
    } else {
        for (const double tick : ticks_of(x_.axis, 7)) ticks.emplace_back(tick, tick_text(tick));
    }
    for (const auto& [tick, label] : ticks) {
        drawing_.line({x_(tick), y_.from}, {x_(tick), y_.from + 8}, 1.6, palette::ink);
        drawing_.text({{x_(tick), y_.from + 40}, label, named_ticks_ ? name_size : tick_size, palette::ink, Anchor::middle});
    }
    for (const double tick : ticks_of(y_.axis, 6)) {
        drawing_.line({x_.from - 8, y_(tick)}, {x_.from, y_(tick)}, 1.6, palette::ink);
        drawing_.text({{x_.from - 14, y_(tick) + 9}, tick_text(tick), tick_size, palette::ink, Anchor::end});
    }
    if (!right_) return;
    for (const double tick : ticks_of(right_->axis, 6)) {
        drawing_.line({x_.to, (*right_)(tick)}, {x_.to + 8, (*right_)(tick)}, 1.6, palette::ink);
        drawing_.text({{x_.to + 14, (*right_)(tick) + 9}, tick_text(tick), tick_size});
    }
}

void Chart::draw_labels() {
    const double middle = (y_.from + y_.to) / 2;
    drawing_.text({{(x_.from + x_.to) / 2, y_.from + 86}, x_.axis.label, label_size, palette::ink, Anchor::middle});
    drawing_.text({{36, middle}, y_.axis.label, label_size, palette::ink, Anchor::middle, false, true});
    if (right_) {
        drawing_.text({{x_.to + 118, middle}, right_->axis.label, label_size, palette::ink, Anchor::middle, false, true});
    }
}

void Chart::draw_entry(const Entry& entry, const std::vector<std::string>& lines, Pixel at) {
    const double y = at.y - 9;
    if (entry.stroke) {
        stroke_line({{at.x, y}, {at.x + legend_mark, y}}, *entry.stroke);
    } else if (entry.marker) {
        draw_marker({at.x + legend_mark / 2, y}, *entry.marker);
    } else {
        drawing_.rectangle({at.x, y - 11}, {at.x + legend_mark, y + 11}, entry.area);
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        drawing_.text({{at.x + legend_mark + 14, at.y + static_cast<double>(i) * legend_line}, lines[i], legend_size});
    }
}

void Chart::draw_legend() {
    const double left = left_margin - 105;
    Pixel at{left, y_.from + (x_.axis.label.empty() ? 96 : 140)};
    for (const Entry& entry : legend_) {
        const double width = legend_mark + 14 + text_width(entry.label, legend_size) + 34;
        if (at.x > left && at.x + width > page_width) at = {left, at.y + legend_line};
        const auto lines = broken_lines(entry.label, legend_size, page_width - left - legend_mark - 14);
        draw_entry(entry, lines, at);
        at.x += width;
        at.y += static_cast<double>(lines.size() - 1) * legend_line;
    }
    drawing_.set_height(static_cast<int>(std::ceil(legend_.empty() ? y_.from + 110 : at.y + 24)));
}

Drawing Chart::finish() {
    drawing_.polyline({{x_.from, y_.from}, {x_.to, y_.from}, {x_.to, y_.to}, {x_.from, y_.to}, {x_.from, y_.from}}, 1.8,
                      palette::ink);
    draw_ticks();
    draw_labels();
    draw_legend();
    return drawing_;
}

}  // namespace graincrack
