// A chart on a page: frame, scales, ticks, curves, markers, bands, legend. Sized to be read at the width of a column.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// One axis: its label with the unit, and the values it spans.
struct Axis {
    std::string label;
    double low = 0;
    double high = 1;
    bool logarithmic = false;
};

struct Stroke {
    Colour colour = palette::ink;
    double width = 4;
    bool dashed = false;
};

enum class MarkerShape { disc, square, triangle, cross };
struct Marker {
    Colour colour = palette::ink;
    MarkerShape shape = MarkerShape::disc;
    double size = 15;
};
/// Another shape for every i, so that series stay apart without colour.
MarkerShape marker_shape(std::size_t i);

struct ChartText {
    std::string title;                  ///< bold
    std::vector<std::string> subtitle;  ///< a line each
};

class Chart {
public:
    /// \param right a second scale for curves drawn on it \param equal_scales one unit is as long on both axes
    Chart(const ChartText& text, const Axis& x, const Axis& y, const std::optional<Axis>& right = std::nullopt,
          bool equal_scales = false);

    enum class Side { left, right };
    /// A line through points; what lies outside the frame is cut off, a NaN interrupts it.
    void line(std::span<const double> x, std::span<const double> y, const Stroke& stroke, Side side = Side::left);
    void points(std::span<const double> x, std::span<const double> y, const Marker& marker);
    /// An upright bar from low to high with a short line across each end.
    void error_bar(double x, double low, double high, Colour colour);
    /// The area between two curves over x, in the frame; drawn under what follows.
    void band(std::span<const double> x, std::span<const double> low, std::span<const double> high, Colour colour);
    /// A filled box between two corners in values.
    void box(double x_low, double x_high, double y_low, double y_high, Colour colour);
    /// Text beside a point.
    void note(double x, double y, const std::string& label, Colour colour = palette::ink, Anchor anchor = Anchor::start);
    /// Ticks along x replaced by texts at points.
    void name_ticks(const std::vector<std::pair<double, std::string>>& ticks) { named_ticks_ = ticks; }

    void legend(const Stroke& stroke, const std::string& label);
    void legend(const Marker& marker, const std::string& label);
    void legend_area(Colour colour, const std::string& label);

    /// Frame, ticks, labels and legend over what was drawn.
    [[nodiscard]] Drawing finish();

private:
    struct Scale {
        Axis axis;
        double from = 0;
        double to = 1;
        [[nodiscard]] double operator()(double value) const;
    };
    struct Entry {
        std::optional<Stroke> stroke;
        std::optional<Marker> marker;
        Colour area;
        std::string label;
    };
    [[nodiscard]] Pixel place(double x, double y) const { return {x_(x), y_(y)}; }
    void stroke_line(const std::vector<Pixel>& points, const Stroke& stroke);
    void draw_marker(Pixel at, const Marker& marker);
    void draw_grid();
    void draw_ticks();
    void draw_labels();
    void draw_legend();
    void draw_entry(const Entry& entry, const std::vector<std::string>& lines, Pixel at);

    Drawing drawing_;
    Scale x_;
    Scale y_;
    std::optional<Scale> right_;
    std::vector<Entry> legend_;
    std::optional<std::vector<std::pair<double, std::string>>> named_ticks_;
};

/// Low and high of values, NaN left out, widened by a share of their distance; {0, 1} without values.
std::pair<double, double> padded_range(std::span<const double> values, double pad);

}  // namespace graincrack
