// A chart on a page: frame, scales, ticks, curves, markers, legend. Sized to be read at the width of a column.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/axis.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/font.hpp"
#include "post/chart/page.hpp"
#include "post/chart/picture_style.hpp"

namespace graincrack {

/// The form of a chart beside its two axes.
struct ChartForm {
    std::optional<Axis> right = {};  ///< a second scale for curves drawn on it
    bool equal_scales = false;       ///< one unit is as long on both axes
    double height = 0;               ///< of the frame, pixels; 0: by the width of the page
    double min_left = 0;             ///< from the edge of the page to the frame, so that charts below one another share it
};

class Chart {
public:
    Chart(const PictureStyle& style, const ChartText& text, const Axis& x, const Axis& y, const ChartForm& form = {});

    enum class Side { left, right };
    using Place = std::array<double, 2>;  ///< values along x and y
    /// A line through points; what lies outside the frame is cut off, a NaN interrupts it. Its label stands in the legend.
    void line(std::span<const double> x, std::span<const double> y, const Stroke& stroke, const std::string& label = "",
              Side side = Side::left);
    void line(Place from, Place to, const Stroke& stroke, const std::string& label = "") {
        const Place x{from[0], to[0]}, y{from[1], to[1]};
        line(std::span<const double>(x), std::span<const double>(y), stroke, label);
    }
    void points(std::span<const double> x, std::span<const double> y, const Marker& marker, const std::string& label = "");
    void point(Place at, const Marker& marker, const std::string& label = "") {
        points(std::span(&at[0], 1), std::span(&at[1], 1), marker, label);
    }
    /// A filled box between two corners in values.
    void box(double x_low, double x_high, double y_low, double y_high, Colour colour);
    /// The area between two curves over the same places.
    void band(std::span<const double> x, std::span<const double> low, std::span<const double> high, Colour colour);
    /// No note comes within `reach` of a point, in pixels of the drawing: that of a marker that is drawn later.
    void keep_clear(Place at, double reach);
    /// Text in a gap of a line, at the first of its places where it covers no other text, no point of `others`, and stays in the
    /// frame. \return whether there is such a place
    bool label_line(std::span<const Place> places, const std::string& label, Colour colour, std::span<const Place> others);

    /// A line of text below the legend.
    void add_note(const std::string& note) { notes_.push_back(note); }
    /// An entry of the legend; none without a label.
    template <class Mark>
    void legend(const Mark& mark, const std::string& label) {
        if (!label.empty()) legend_.push_back({mark, label});
    }

    /// Frame, ticks, labels and legend over what was drawn. \throws UsageError if limits of the style show nothing
    [[nodiscard]] Drawing finish();

private:
    /// An axis and where it lies on the page.
    struct Scale {
        Axis axis;
        double from = 0;
        double to = 1;
        [[nodiscard]] double operator()(double value) const { return from + axis.share(value) * (to - from); }
    };
    [[nodiscard]] Pixel place(double x, double y) const { return {x_(x), y_(y)}; }
    [[nodiscard]] bool inside(Pixel at) const;
    void lay_out(double top, const ChartForm& form);
    void draw_grid();
    /// \return where the labels of the ticks end
    double draw_x_ticks();
    void draw_y_ticks(const Scale& scale, bool right);
    void draw_labels(double below_ticks);
    void require_contents() const;

    PictureStyle style_;
    Axis x_unlimited_;  ///< as they would be without limits
    Axis y_unlimited_;
    Drawing drawing_;
    Scale x_;
    Scale y_;
    std::optional<Scale> right_;
    bool shows_something_ = false;
    std::vector<LegendEntry> legend_;
    std::vector<std::string> notes_;  ///< below the legend
    std::vector<TextBox> taken_;      ///< by texts and markers in the frame
};

}  // namespace graincrack
