#include "post/chart/map_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "post/chart/axis.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/font.hpp"
#include "post/run/crystals.hpp"
#include "post/run/test_label.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

/// Twice the signed area of a triangle.
double cross(Pixel a, Pixel b, Pixel c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Fills triangles smaller than a few pixels pixel by pixel, so that the page bounds the size of a picture, not the number of
/// grains.
class PixelFill {
public:
    /// Covers the pixels between two corners of the page.
    PixelFill(Pixel top_left, Pixel bottom_right)
        : left_(std::floor(top_left.x)),
          top_(std::floor(top_left.y)),
          columns_(static_cast<std::size_t>(std::max(0.0, std::ceil(bottom_right.x) - left_))),
          rows_(static_cast<std::size_t>(std::max(0.0, std::ceil(bottom_right.y) - top_))),
          cells_(columns_ * rows_) {}
    /// Colours the pixels whose centres lie in a triangle of any orientation, within the page.
    void triangle(Pixel a, Pixel b, Pixel c, Colour colour) {
        const double sense = cross(a, b, c) < 0 ? -1 : 1;
        const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
        const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
        const auto first = [](double low, double from) { return std::max(0.0, std::ceil(low - from - 0.5)); };
        const auto last = [](double high, double from, std::size_t n) {
            return std::min(static_cast<double>(n) - 1, std::floor(high - from - 0.5));
        };
        for (double row = first(y_low, top_); row <= last(y_high, top_, rows_); ++row) {
            for (double column = first(x_low, left_); column <= last(x_high, left_, columns_); ++column) {
                const Pixel centre{left_ + column + 0.5, top_ + row + 0.5};
                const bool is_inside =
                    sense * cross(a, b, centre) >= 0 && sense * cross(b, c, centre) >= 0 && sense * cross(c, a, centre) >= 0;
                if (is_inside) cells_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)] = colour;
            }
        }
    }
    /// Adds the coloured pixels to a drawing: one rectangle for each run of one colour in a row.
    void draw(Drawing& drawing) const {
        constexpr double overlap = 0.5;  // downwards, so that no gaps appear between rows when a viewer scales the picture
        for (std::size_t row = 0; row < rows_; ++row) {
            for (std::size_t from = 0; from < columns_;) {
                const std::optional<Colour>& cell = cells_[row * columns_ + from];
                std::size_t to = from + 1;
                while (to < columns_ && cells_[row * columns_ + to] == cell) ++to;
                const double y = top_ + static_cast<double>(row);
                if (cell) {
                    drawing.rectangle({left_ + static_cast<double>(from), y}, {left_ + static_cast<double>(to), y + 1 + overlap},
                                      *cell);
                }
                from = to;
            }
        }
    }

private:
    double left_, top_;
    std::size_t columns_, rows_;
    std::vector<std::optional<Colour>> cells_;
};

constexpr double platen_height = 16;
/// Edge in pixels below which grains have no outlines, which would cover the map in grey. Chosen by trial.
constexpr double min_edge = 4;

/// The largest 1, 2 or 5 × 10^k below a length.
double round_length(double length) {
    const double decade = std::pow(10.0, std::floor(std::log10(length)));
    for (double factor : {5.0, 2.0}) {
        if (factor * decade <= length) return factor * decade;
    }
    return decade;
}

MapBox bounds(const Positions& places) {
    MapBox box;
    for (const auto& place : places) box.include({place, place});
    return box;
}

Colour between(Colour from, Colour to, double share) {
    const auto channel = [share](double a, double b) { return static_cast<std::uint8_t>(std::lround(a + share * (b - a))); };
    return {channel(from.red, to.red), channel(from.green, to.green), channel(from.blue, to.blue)};
}

}  // namespace

Colour ColourScale::of(double value) const {
    constexpr double middle = 0.7, steps = 64;  // few colours make few shapes
    const double share = std::round(steps * std::min(1.0, std::abs(value) / std::max({-low, high, 1e-300}))) / steps;
    const Colour end = value < 0 ? Colour{230, 140, 30} : Colour{0, 114, 178};
    if (share < middle) return between(palette::white, end, share / middle);
    return between(end, value < 0 ? Colour{120, 40, 0} : Colour{0, 40, 90}, (share - middle) / (1 - middle));
}

void ColourScale::include(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return;
    std::ranges::sort(values);
    low = std::min(low, values[values.size() / 100]);
    high = std::max(high, values[values.size() - 1 - values.size() / 100]);
}

double ColourScale::draw(Drawing& page, const TextColumn& column, double top) const {
    constexpr double height = 22, most_wide = 560, mark = 8;
    constexpr int steps = 128;
    const double width = std::min(most_wide, column.right - column.left - 60);
    const double left = column.left + 30;
    const Axis axis{label, low, high > low ? high : low + 1};
    const Ticks ticks = ticks_along(axis, width, letters::text, 6);
    const double end = draw_heading(page, {"", {ticks.label}}, column, top) + 8;
    for (int i = 0; i < steps; ++i) {  // each reaches the end, so that no seams show
        page.rectangle({left + width * i / steps, end}, {left + width, end + height},
                       of(low + (axis.high - low) * (i + 0.5) / steps));
    }
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double x = left + width * axis.share(ticks.values[i]);
        page.line({x, end + height}, {x, end + height + mark}, 2, palette::ink);
        page.text({{x, end + height + mark + letters::text}, ticks.texts[i], letters::text, palette::ink, Anchor::middle});
    }
    return end + height + mark + 1.4 * letters::text;
}

void MapBox::include(const MapBox& other) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], other.low[axis]);
        high[axis] = std::max(high[axis], other.high[axis]);
    }
}

MapBox view_box(const Specimen& specimen, const Positions& positions) {
    const MapBox rest = bounds(specimen.node_position);
    MapBox box = bounds(positions);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double reach = 0.1 * (rest.high[axis] - rest.low[axis]);
        box.low[axis] = std::clamp(box.low[axis], rest.low[axis] - reach, rest.low[axis] + reach);
        box.high[axis] = std::clamp(box.high[axis], rest.high[axis] - reach, rest.high[axis] + reach);
    }
    return box;
}

Positions moved_nodes(const Specimen& specimen, const Frame& frame, double magnification) {
    Positions places = specimen.node_position;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i][0] += magnification * frame.displacement[i][0];
        places[i][1] += magnification * frame.displacement[i][1];
    }
    return places;
}

MapView::MapView(const Specimen& specimen, Positions positions, const ChartText& text, const MapPage& page)
    : specimen_(specimen), positions_(std::move(positions)), page_(page), drawing_(static_cast<int>(page.style.page_width), 0) {
    const MapBox box = page.view ? *page.view : view_box(specimen_, positions_);
    low_ = box.low;
    high_ = box.high;
    ChartText heading = text;
    if (!page.style.title.empty()) heading.title = page.style.title;
    constexpr double above = 14;
    const double end = draw_heading(drawing_, heading, {page.margin, drawing_.width() - page.margin}, above);
    const double top = std::max(end, above + page.heading_height) + platen_height + 12;
    const double width = high_[0] - low_[0];
    const double height = high_[1] - low_[1];
    scale_ = std::min((drawing_.width() - 2 * page.margin) / width, page.largest_height / height);
    origin_ = {(drawing_.width() - scale_ * width) / 2, top + scale_ * height};
    drawing_.set_height(origin_.y + platen_height + 12);
}

Pixel MapView::pixel(std::array<double, 2> place) const {
    return {origin_.x + scale_ * (place[0] - low_[0]), origin_.y - scale_ * (place[1] - low_[1])};
}

bool MapView::visible(std::array<double, 2> place) const {
    const double slack = 2 / scale_;
    return place[0] >= low_[0] - slack && place[0] <= high_[0] + slack && place[1] >= low_[1] - slack &&
           place[1] <= high_[1] + slack;
}

void MapView::stroke(std::array<double, 2> from, std::array<double, 2> to, double width, Colour colour) {
    if (visible({(from[0] + to[0]) / 2, (from[1] + to[1]) / 2})) drawing_.line(pixel(from), pixel(to), width, colour);
}

void MapView::draw_outline(std::int32_t from, std::int32_t to, double width, Colour colour) {
    stroke(positions_[static_cast<std::size_t>(from)], positions_[static_cast<std::size_t>(to)], width, colour);
}

template <class Draw>
void MapView::each_grain(const std::vector<double>& values, const Draw& draw) const {
    const std::vector<Colour> colours = palette::phases(specimen_.phase_names);
    for (std::size_t e = 0; e < specimen_.n_elements(); ++e) {
        const auto& nodes = specimen_.element_nodes[e];
        const auto place = [&](std::size_t k) { return positions_[static_cast<std::size_t>(nodes[k])]; };
        const auto [a, b, c] = std::array{place(0), place(1), place(2)};
        if (!visible({(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3})) continue;
        const auto grain = static_cast<std::size_t>(specimen_.element_grain[e]);
        draw(pixel(a), pixel(b), pixel(c),
             page_.colours ? page_.colours->of(values.at(e)) : colours[specimen_.grain_phase[grain]]);
    }
}

void MapView::draw_grains(const std::vector<double>& values) {
    const double edge = specimen_.statistics.mean_edge > 0 ? specimen_.statistics.mean_edge * scale_ : 1e3;
    if (edge < min_edge) return draw_small_grains(values);
    each_grain(values, [&](Pixel a, Pixel b, Pixel c, Colour fill) { drawing_.polygon({a, b, c}, fill); });
    const double thin = std::clamp(0.03 * edge, 0.3, 1.2);
    const auto apart = [&](std::int32_t a, std::int32_t b) {
        const auto& p = positions_[static_cast<std::size_t>(a)];
        const auto& q = positions_[static_cast<std::size_t>(b)];
        return std::hypot(p[0] - q[0], p[1] - q[1]) * scale_ > 0.2 * thin;
    };
    for (const bool is_within : {true, false}) {  // outlines of crystals cover those within them
        const Colour outline = is_within || specimen_.grain_crystal.empty() ? palette::outline : palette::rim;
        for (std::size_t c = 0; c < specimen_.n_contacts(); ++c) {
            if (is_within_crystal(specimen_, c) != is_within) continue;
            const auto& nodes = specimen_.contact_nodes[c];
            draw_outline(nodes[0], nodes[1], is_within ? 0.6 * thin : thin, outline);
            const bool gapes = apart(nodes[0], nodes[2]) || apart(nodes[1], nodes[3]);
            if (gapes) draw_outline(nodes[2], nodes[3], is_within ? 0.6 * thin : thin, outline);
        }
    }
    for (const auto& nodes : specimen_.boundary_edges) draw_outline(nodes[0], nodes[1], 1.6 * thin, palette::rim);
}

bool MapView::draw_flaws(double width, bool are_broken) {
    bool any = false;
    for (std::size_t c = 0; c < specimen_.n_contacts(); ++c) {
        const bool is_broken = starts_broken(specimen_.contact_kind[c]);
        const bool is_flaw = is_broken || (!specimen_.contact_flaw.empty() && specimen_.contact_flaw[c] > 0);
        if (!is_flaw || is_broken != are_broken || is_within_crystal(specimen_, c)) continue;
        draw_outline(specimen_.contact_nodes[c][0], specimen_.contact_nodes[c][1], width,
                     are_broken ? palette::pre_existing : palette::intact_flaw);
        any = true;
    }
    return any;
}

void MapView::draw_small_grains(const std::vector<double>& values) {
    PixelFill fill(pixel({low_[0], high_[1]}), pixel({high_[0], low_[1]}));
    each_grain(values, [&](Pixel a, Pixel b, Pixel c, Colour own) { fill.triangle(a, b, c, own); });
    fill.draw(drawing_);
    for (const auto& nodes : specimen_.boundary_edges) draw_outline(nodes[0], nodes[1], 1.5, palette::rim);
}

void MapView::draw_platens(const PlatenFaceSet& set, double approach) {
    for (const PlatenFace& face : set.faces) {
        std::array<Pixel, 4> corners;
        const auto places = set.bar(face, platen_height / scale_, approach);
        std::transform(places.begin(), places.end(), corners.begin(), [&](const auto& place) { return pixel(place); });
        drawing_.polygon(corners, palette::platen);
    }
}

std::vector<LegendEntry> phase_legend(const Specimen& specimen) {
    std::vector<LegendEntry> entries;
    const std::vector<Colour> colours = palette::phases(specimen.phase_names);
    const std::size_t n = colours.size();
    for (std::size_t i = 0; n > 1 && i < n; ++i) entries.push_back({colours[i], mineral_label(specimen.phase_names[i])});
    return entries;
}

double draw_scale_bar(Drawing& page, const MapScale& scale, const TextColumn& column, const LegendEnd& end) {
    const double length = round_length(0.3 * scale.width);
    const std::string label = format_length(length);
    const double left = column.right - length * scale.pixels_per_metre;
    const double room = text_width(label, letters::text) + 14;
    const bool beside = end.last.x > column.left && left - room > end.last.x + 30;
    const double baseline = beside ? end.last.y : end.bottom + 0.78 * legend_line;
    page.line({left, baseline - 8}, {column.right, baseline - 8}, 3, palette::ink);
    for (const double x : {left, column.right}) page.line({x, baseline - 16}, {x, baseline}, 3, palette::ink);
    page.text({{left - 14, baseline}, label, letters::text, palette::ink, Anchor::end});
    return beside ? end.bottom : end.bottom + legend_line;
}

void MapView::draw_legend(const std::vector<LegendEntry>& entries, const std::vector<std::string>& notes) {
    const TextColumn column{page_margin, drawing_.width() - page_margin};
    double top = drawing_.height() + 6;
    if (page_.colours) top = page_.colours->draw(drawing_, column, top);
    const LegendEnd end = graincrack::draw_legend(drawing_, entries, column, top);
    const double bottom = draw_scale_bar(drawing_, scale(), column, end);
    drawing_.set_height(draw_heading(drawing_, {"", notes}, column, bottom) + 14);
}

namespace {

constexpr double within_crystals = 0.55;  ///< width of a crack within a crystal over that of one between two

/// Draws the half facet of a failed contact point: one line midway between its sides or, if the crack is open, one on each side.
void draw_crack(MapView& map, const Specimen& specimen, const Crack& crack, double width) {
    const auto& nodes = specimen.contact_nodes[static_cast<std::size_t>(crack.contact)];
    const auto at = [&](std::size_t k) { return map.positions()[static_cast<std::size_t>(nodes[k])]; };
    const auto between = [](std::array<double, 2> p, std::array<double, 2> q) {
        return std::array{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    };
    const Colour colour = crack.mode == CrackMode::tensile ? palette::tensile : palette::shear;
    const auto draw = [&](std::array<double, 2> first, std::array<double, 2> second, double stroke) {
        const auto middle = between(first, second);
        map.stroke(crack.point == 0 ? first : middle, crack.point == 0 ? middle : second, stroke, colour);
    };
    const std::size_t end = crack.point;  // a1, b1 or a2, b2
    const auto side_a = at(end);
    const auto side_b = at(end + 2);
    const double gap = std::hypot(side_a[0] - side_b[0], side_a[1] - side_b[1]) * map.pixels_per_metre();
    if (gap <= 2 * width) {
        draw(between(at(0), at(2)), between(at(1), at(3)), width);
    } else {
        draw(at(0), at(1), 0.7 * width);
        draw(at(2), at(3), 0.7 * width);
    }
}

}  // namespace

bool has_platens_to_draw(const RunData& run) { return run.header.loading() != Loading::tension; }

bool has_pre_existing_cracks(const Specimen& specimen) {
    return std::any_of(specimen.contact_kind.begin(), specimen.contact_kind.end(), starts_broken);
}

void draw_cracks(MapView& map, const Specimen& specimen, const std::vector<Crack>& present) {
    const double edge = specimen.statistics.mean_edge * map.pixels_per_metre();
    const double width = edge > 0 ? std::clamp(0.1 * edge, 1.2, 6.0) : 4.0;
    map.draw_flaws(width, true);
    for (const CrackMode mode : {CrackMode::shear, CrackMode::tensile}) {
        for (const Crack& crack : present) {
            if (crack.mode != mode) continue;
            const bool is_within = is_within_crystal(specimen, static_cast<std::size_t>(crack.contact));
            draw_crack(map, specimen, crack, is_within ? within_crystals * width : width);
        }
    }
}

std::string cracked_contacts(const std::vector<Crack>& cracks, CrackMode mode) {
    const auto points = std::count_if(cracks.begin(), cracks.end(), [mode](const Crack& c) { return c.mode == mode; });
    return whole_contacts(0.5 * static_cast<double>(points));
}

std::vector<std::string> crack_notes(const Specimen& specimen, const CrackLabel& label) {
    std::vector<std::string> lines{definition_of(label)};
    if (!specimen.grain_crystal.empty()) lines.emplace_back("thin: within crystals; thick: between them");
    return lines;
}

}  // namespace graincrack
