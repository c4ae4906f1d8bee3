// A chart on a page: frame, scales, ticks, curves, markers and legend, readable at the width of a column.
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

/// The form of a chart in addition to its two axes.
struct ChartForm {
    std::optional<Axis> right = {};  ///< second scale at the right
    bool equal_scales = false;       ///< equal lengths of a unit on both axes
    double height = 0;               ///< height of the frame, pixels; 0: derived from the width of the page
    double min_left = 0;             ///< least distance of the frame from the edge of the page, pixels, to align charts
};

class Chart {
public:
    Chart(const PictureStyle& style, const ChartText& text, const Axis& x, const Axis& y, const ChartForm& form = {});

    enum class Side { left, right };
    using Place = std::array<double, 2>;  ///< values along x and y
    /// Draws a line through points, clipped to the frame and interrupted at NaN. Its label goes to the legend.
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
    /// Draws a filled box between two corners in values.
    void box(double x_low, double x_high, double y_low, double y_high, Colour colour);
    /// Fills the area between two curves over the same x.
    void band(std::span<const double> x, std::span<const double> low, std::span<const double> high, Colour colour);
    /// Keeps labels away from a point by `reach` pixels, such as from a marker drawn later.
    void keep_clear(Place at, double reach);
    /// Draws a label in a gap of a line, at the first of its places within the frame where it covers no other text and no point
    /// of `others`. \return false if there is no such place
    bool label_line(std::span<const Place> places, const std::string& label, Colour colour, std::span<const Place> others);

    /// Adds a line of text below the legend.
    void add_note(const std::string& note) { notes_.push_back(note); }
    /// Adds an entry of the legend unless its label is empty.
    template <class Mark>
    void legend(const Mark& mark, const std::string& label) {
        if (!label.empty()) legend_.push_back({mark, label});
    }

    /// Draws frame, ticks, labels and legend over the content. \throws UsageError if limits of the style leave nothing visible
    [[nodiscard]] Drawing finish();

private:
    /// An axis and its place on the page.
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
    /// \return bottom of the labels of the ticks, pixels
    double draw_x_ticks();
    void draw_y_ticks(const Scale& scale, bool right);
    void draw_labels(double below_ticks);
    void require_contents() const;

    PictureStyle style_;
    Axis x_unlimited_;  ///< axes without limits
    Axis y_unlimited_;
    Drawing drawing_;
    Scale x_;
    Scale y_;
    std::optional<Scale> right_;
    bool shows_something_ = false;
    std::vector<LegendEntry> legend_;
    std::vector<std::string> notes_;  ///< below the legend
    std::vector<TextBox> taken_;      ///< boxes of texts and markers in the frame
};

}  // namespace graincrack
