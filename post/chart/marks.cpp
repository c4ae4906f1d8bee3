#include "post/chart/marks.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace graincrack {

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

/// Corners of a shape in halves of its size, closed; a disc has many.
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
