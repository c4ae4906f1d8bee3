#include "post/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "share/base/error.hpp"

namespace graincrack {

namespace {

constexpr double tick_length = 8;
constexpr double tick_gap = 8;     ///< distance from a tick to its text
constexpr double right_room = 40;  ///< room beside the frame for half of a tick's text
constexpr double digit_rise = 0.36;
constexpr double faint_line = 1;

double largest_width(const std::vector<std::string>& texts) {
    double width = 0;
    for (const std::string& text : texts) width = std::max(width, text_width(text, letters::text));
    return width;
}

/// The label of an upright axis, in two lines if it is longer than the frame is high.
std::vector<std::string> upright_lines(const std::string& label, double height) {
    return broken_lines(label, letters::label, height);
}
constexpr double upright_leading = 1.15 * letters::label;

/// The ticks of an upright axis, fewer if their texts have no room above one another.
Ticks upright_ticks(const Axis& axis, double height) {
    return ticks_of(axis, std::clamp(static_cast<int>(height / (1.4 * letters::text)), 2, 6));
}

/// Room beside a frame for the ticks and the label of an axis, pixels.
double room_beside(const Axis& axis, double height) {
    const Ticks ticks = upright_ticks(axis, height);
    const auto lines = static_cast<double>(upright_lines(ticks.label, height).size());
    return tick_length + tick_gap + largest_width(ticks.texts) + 10 + lines * upright_leading;
}

Axis limited(const Axis& axis, const std::optional<AxisLimits>& limits) { return limits ? axis.limited(*limits) : axis; }

/// Clips a segment to a box (Liang & Barsky); false if nothing is inside.
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

/// A line being drawn, without steps too small to be seen but with its end.
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

Chart::Chart(const PictureStyle& style, const ChartText& text, const Axis& x, const Axis& y, const ChartForm& form)
    : style_(style),
      x_unlimited_(x),
      y_unlimited_(y),
      drawing_(static_cast<int>(style.page_width), 100),
      x_{limited(x, style.x_limits), 0, 0},
      y_{limited(y, style.y_limits), 0, 0} {
    notes_ = text.notes;
    if (form.right) right_ = Scale{*form.right, 0, 0};
    ChartText heading = text;
    if (!style.title.empty()) heading.title = style.title;
    const double end = draw_heading(drawing_, heading, {page_margin, drawing_.width() - page_margin}, 0.6 * page_margin);
    lay_out(end + 24, form);
    draw_grid();
}

void Chart::lay_out(double top, const ChartForm& form) {
    constexpr double edge = 0.3 * page_margin;
    double height = form.height > 0 ? form.height : 19 * std::sqrt(style_.page_width);
    x_.from = std::max(form.min_left, edge + room_beside(y_.axis, height));
    x_.to = drawing_.width() - (right_ ? edge + room_beside(right_->axis, height) : right_room);
    const double width = x_.to - x_.from;
    if (form.equal_scales) {
        const double shape = (y_.axis.high - y_.axis.low) / (x_.axis.high - x_.axis.low);
        const double most = 1.2 * width;
        height = std::min(width * shape, most);
        x_.to = x_.from + height / shape;
    }
    y_.from = top + height;
    y_.to = top;
    if (right_) {
        right_->from = y_.from;
        right_->to = y_.to;
    }
}

bool Chart::inside(Pixel at) const {
    return at.x >= x_.from - 1 && at.x <= x_.to + 1 && at.y >= y_.to - 1 && at.y <= y_.from + 1;
}

void Chart::draw_grid() {
    for (const double tick : ticks_along(x_.axis, x_.to - x_.from, letters::text, 8).values) {
        drawing_.line({x_(tick), y_.from}, {x_(tick), y_.to}, faint_line, palette::faint);
    }
    for (const double tick : upright_ticks(y_.axis, y_.from - y_.to).values) {
        drawing_.line({x_.from, y_(tick)}, {x_.to, y_(tick)}, faint_line, palette::faint);
    }
    const auto crossed = [](const Axis& axis) { return !axis.logarithmic && axis.low < 0 && axis.high > 0; };
    if (crossed(x_.axis)) drawing_.line({x_(0), y_.from}, {x_(0), y_.to}, 1.6, palette::rim);
    if (crossed(y_.axis)) drawing_.line({x_.from, y_(0)}, {x_.to, y_(0)}, 1.6, palette::rim);
}

void Chart::line(std::span<const double> x, std::span<const double> y, const Stroke& stroke, const std::string& label,
                 Side side) {
    legend(stroke, label);
    const Scale& scale = side == Side::right && right_ ? *right_ : y_;
    LineInHand hand;
    const auto finish = [&] {
        draw_stroke(drawing_, hand.finish(), stroke);
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
        shows_something_ = true;
        if (!hand.goes_on_at(from)) finish();
        hand.add(from, to);
    }
    finish();
}

void Chart::points(std::span<const double> x, std::span<const double> y, const Marker& marker, const std::string& label) {
    legend(marker, label);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Pixel at = place(x[i], y[i]);
        if (!inside(at)) continue;
        shows_something_ = true;
        draw_marker(drawing_, at, marker);
    }
}

void Chart::box(double x_low, double x_high, double y_low, double y_high, Colour colour) {
    const auto across = [&](double value) { return std::clamp(x_(value), x_.from, x_.to); };
    const auto up = [&](double value) { return std::clamp(y_(value), y_.to, y_.from); };
    drawing_.rectangle({across(x_low), up(y_high)}, {across(x_high), up(y_low)}, colour);
}

void Chart::band(std::span<const double> x, std::span<const double> low, std::span<const double> high, Colour colour) {
    std::vector<Pixel> outline;
    const auto add = [&](double at, double value) {
        outline.push_back({std::clamp(x_(at), x_.from, x_.to), std::clamp(y_(value), y_.to, y_.from)});
    };
    for (std::size_t i = 0; i < x.size(); ++i) add(x[i], low[i]);
    for (std::size_t i = x.size(); i-- > 0;) add(x[i], high[i]);
    drawing_.polygon(outline, colour);
}

void Chart::keep_clear(Place at, double reach) {
    const Pixel centre = place(at[0], at[1]);
    taken_.push_back({centre.x - reach, centre.y - reach, centre.x + reach, centre.y + reach});
}

bool Chart::label_line(std::span<const Place> places, const std::string& label, Colour colour, std::span<const Place> others) {
    constexpr double gap = 5;
    for (const auto& [x, y] : places) {
        const Text text{{x_(x), y_(y) + digit_rise * letters::text}, label, letters::text, colour, Anchor::middle};
        TextBox box = box_of(text);
        box = {box.left - gap, box.top - gap, box.right + gap, box.bottom + gap};
        const auto is_hit = [&](const Place& other) {
            const Pixel at = place(other[0], other[1]);
            return at.x > box.left && at.x < box.right && at.y > box.top && at.y < box.bottom;
        };
        const bool fits = box.left >= x_.from && box.right <= x_.to && box.top >= y_.to && box.bottom <= y_.from;
        if (!fits || std::any_of(taken_.begin(), taken_.end(), [&](const TextBox& each) { return box.overlaps(each); })) continue;
        if (std::any_of(others.begin(), others.end(), is_hit)) continue;
        taken_.push_back(box);
        drawing_.rectangle({box.left, box.top}, {box.right, box.bottom}, palette::white);
        drawing_.text(text);
        return true;
    }
    return false;
}

double Chart::draw_x_ticks() {
    const double first = y_.from + tick_length + tick_gap + 0.75 * letters::text;
    const Ticks ticks = ticks_along(x_.axis, x_.to - x_.from, letters::text, 8);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double x = x_(ticks.values[i]);
        drawing_.line({x, y_.from}, {x, y_.from + tick_length}, 1.6, palette::ink);
        drawing_.text({{x, first}, ticks.texts[i], letters::text, palette::ink, Anchor::middle});
    }
    return first;
}

void Chart::draw_y_ticks(const Scale& scale, bool right) {
    const double side = right ? 1 : -1;
    const double edge = right ? x_.to : x_.from;
    const Ticks ticks = upright_ticks(scale.axis, y_.from - y_.to);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y = scale(ticks.values[i]);
        drawing_.line({edge, y}, {edge + side * tick_length, y}, 1.6, palette::ink);
        drawing_.text({{edge + side * (tick_length + tick_gap), y + digit_rise * letters::text},
                       ticks.texts[i],
                       letters::text,
                       palette::ink,
                       right ? Anchor::start : Anchor::end});
    }
    const auto lines = upright_lines(ticks.label, y_.from - y_.to);
    const double first = right
                             ? drawing_.width() - 0.25 * letters::label - static_cast<double>(lines.size() - 1) * upright_leading
                             : 0.8 * letters::label;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double x = first + (right ? -0.3 : 0.3) * page_margin + static_cast<double>(i) * upright_leading;
        drawing_.text({{x, (y_.from + y_.to) / 2}, lines[i], letters::label, palette::ink, Anchor::middle, false, true});
    }
}

void Chart::draw_labels(double below_ticks) {
    double y = below_ticks;
    if (!x_.axis.label.empty()) {
        const std::string label = ticks_along(x_.axis, x_.to - x_.from, letters::text, 8).label;
        for (const std::string& line : broken_lines(label, letters::label, drawing_.width() - x_.from)) {
            y += 1.45 * letters::label;
            drawing_.text({{(x_.from + x_.to) / 2, y}, line, letters::label, palette::ink, Anchor::middle});
        }
    }
    const TextColumn column{page_margin, drawing_.width() - 0.5 * page_margin};
    if (!legend_.empty()) y = draw_legend(drawing_, legend_, column, y + 22).bottom - 10;
    if (!notes_.empty()) y = draw_heading(drawing_, {"", notes_}, column, y + (legend_.empty() ? 22 : 10)) - 10;
    drawing_.set_height(y + 24);
}

void Chart::require_contents() const {
    if (shows_something_ || (!style_.x_limits && !style_.y_limits)) return;
    std::string text;
    for (const auto& [limits, axis] : {std::pair(&style_.x_limits, &x_unlimited_), std::pair(&style_.y_limits, &y_unlimited_)}) {
        if (!*limits) continue;
        text += (text.empty() ? "" : " and ") + (*limits)->text;
        text += fmt::format(" (all of it: {:.4g},{:.4g})", axis->low, axis->high);
    }
    throw UsageError(text + ": nothing lies there; limits within what the axis shows without them fit");
}

Drawing Chart::finish() {
    require_contents();
    drawing_.polyline({{x_.from, y_.from}, {x_.to, y_.from}, {x_.to, y_.to}, {x_.from, y_.to}, {x_.from, y_.from}}, 1.8,
                      palette::ink);
    const double below = draw_x_ticks();
    draw_y_ticks(y_, false);
    if (right_) draw_y_ticks(*right_, true);
    draw_labels(below);
    return drawing_;
}

}  // namespace graincrack
