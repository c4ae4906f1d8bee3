#include "post/chart/marks.hpp"

#include <array>
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

void draw_marker(Drawing& drawing, Pixel at, const Marker& marker) {
    const double r = marker.size / 2;
    const auto moved = [&](double x, double y) { return Pixel{at.x + x * r, at.y + y * r}; };
    switch (marker.shape) {
        case MarkerShape::disc: drawing.polyline({at, at}, marker.size, marker.colour); break;
        case MarkerShape::square: drawing.rectangle(moved(-0.9, -0.9), moved(0.9, 0.9), marker.colour); break;
        case MarkerShape::triangle: drawing.polygon({moved(0, -1.2), moved(1.1, 0.8), moved(-1.1, 0.8)}, marker.colour); break;
        case MarkerShape::cross:
            drawing.line(moved(-1, -1), moved(1, 1), 0.3 * marker.size, marker.colour);
            drawing.line(moved(-1, 1), moved(1, -1), 0.3 * marker.size, marker.colour);
            break;
        case MarkerShape::diamond:
            drawing.polygon({moved(0, -1.2), moved(1.2, 0), moved(0, 1.2), moved(-1.2, 0)}, marker.colour);
            break;
        case MarkerShape::leaves: drawing.polygon({moved(-1.2, 0), moved(0.8, -1.1), moved(0.8, 1.1)}, marker.colour); break;
    }
}

}  // namespace graincrack
