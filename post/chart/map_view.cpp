#include "post/chart/map_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/chart/font.hpp"
#include "post/chart/labels.hpp"
#include "post/chart/pixel_fill.hpp"
#include "post/run/crystals.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

constexpr double platen_height = 16;
/// Grains of shorter edges, in pixels, have no outlines: they would cover the map in grey.
constexpr double min_edge = 4;

/// 1, 2 or 5 × 10^k below a length.
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

}  // namespace

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
void MapView::each_grain(const GrainColour& colour, const Draw& draw) const {
    for (std::size_t e = 0; e < specimen_.n_elements(); ++e) {
        const auto& nodes = specimen_.element_nodes[e];
        const auto place = [&](std::size_t k) { return positions_[static_cast<std::size_t>(nodes[k])]; };
        const auto [a, b, c] = std::array{place(0), place(1), place(2)};
        if (!visible({(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3})) continue;
        const auto grain = static_cast<std::size_t>(specimen_.element_grain[e]);
        draw(pixel(a), pixel(b), pixel(c), colour ? colour(grain) : palette::phase(specimen_.grain_phase[grain]));
    }
}

void MapView::draw_grains(const GrainColour& colour) {
    const double edge = specimen_.statistics.mean_edge > 0 ? specimen_.statistics.mean_edge * scale_ : 1e3;
    if (edge < min_edge) return draw_small_grains(colour);
    each_grain(colour, [&](Pixel a, Pixel b, Pixel c, Colour fill) { drawing_.polygon({a, b, c}, fill); });
    const double thin = std::clamp(0.03 * edge, 0.3, 1.2);
    const auto apart = [&](std::int32_t a, std::int32_t b) {
        const auto& p = positions_[static_cast<std::size_t>(a)];
        const auto& q = positions_[static_cast<std::size_t>(b)];
        return std::hypot(p[0] - q[0], p[1] - q[1]) * scale_ > 0.2 * thin;
    };
    for (const bool is_within : {true, false}) {  // outlines of crystals lie above what is within them
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

bool MapView::draw_pre_existing_cracks(double width) {
    bool any = false;
    for (std::size_t c = 0; c < specimen_.n_contacts(); ++c) {
        if (!starts_broken(specimen_.contact_kind[c])) continue;
        draw_outline(specimen_.contact_nodes[c][0], specimen_.contact_nodes[c][1], width, palette::pre_existing);
        any = true;
    }
    return any;
}

void MapView::draw_small_grains(const GrainColour& colour) {
    PixelFill fill(pixel({low_[0], high_[1]}), pixel({high_[0], low_[1]}));
    each_grain(colour, [&](Pixel a, Pixel b, Pixel c, Colour own) { fill.triangle(a, b, c, own); });
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

void MapView::draw_boundaries(const std::function<bool(std::size_t contact)>& is_boundary, double width) {
    for (std::size_t c = 0; c < specimen_.n_contacts(); ++c) {
        if (!is_boundary(c)) continue;
        const auto& nodes = specimen_.contact_nodes[c];
        draw_outline(nodes[0], nodes[1], width, palette::ink);
        draw_outline(nodes[2], nodes[3], width, palette::ink);
    }
}

std::vector<LegendEntry> phase_legend(const Specimen& specimen) {
    std::vector<LegendEntry> entries;
    const std::size_t n = specimen.phase_names.size();
    for (std::size_t i = 0; n > 1 && i < n; ++i) entries.push_back({palette::phase(i), mineral_label(specimen.phase_names[i])});
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
    const LegendEnd end = graincrack::draw_legend(drawing_, entries, column, drawing_.height() + 6);
    const double bottom = draw_scale_bar(drawing_, scale(), column, end);
    drawing_.set_height(draw_heading(drawing_, {"", notes}, column, bottom) + 14);
}

}  // namespace graincrack
