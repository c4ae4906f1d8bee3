#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "post/chart/font.hpp"
#include "post/chart/page.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

using Bins = std::array<double, Rosette::n_bins>;

double total(const Bins& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }

Bins shares(Bins lengths) {
    const double all = total(lengths);
    for (double& length : lengths) length /= all > 0 ? all : 1;
    return lengths;
}

/// Fractions at which two or three rings are drawn.
std::vector<double> rings_within(double largest) {
    std::vector<double> rings = round_ticks(0, largest, 3);
    std::erase_if(rings, [](double ring) { return ring == 0; });
    return rings;
}

/// A rose around a centre, whose petals have full length at `scale`.
class Rose {
public:
    Rose(Drawing& drawing, Pixel centre, double radius, double scale)
        : drawing_(drawing), centre_(centre), radius_(radius), scale_(scale) {}

    void rings() {
        for (const double ring : rings_within(scale_)) {
            std::vector<Pixel> circle;
            for (int i = 0; i <= 72; ++i) circle.push_back(at(std::numbers::pi * i / 36, ring));
            drawing_.polyline(circle, 1.4, palette::outline);
        }
        for (int i = 0; i < 12; ++i) drawing_.line(centre_, at(std::numbers::pi * i / 6, scale_), 1, palette::faint);
    }
    /// Draws the labels of the rings last, inside them and perpendicular to the load, where the fewest cracks are.
    void scale_labels() {
        constexpr double size = letters::text;
        for (const double ring : rings_within(scale_)) {
            const std::string percent = fmt::format("{:.0f} %", 100 * ring);
            const double half = text_width(percent, size) / 2;
            const Pixel label{at(0, ring).x - half - 4, centre_.y};
            drawing_.rectangle({label.x - half, label.y - 0.6 * size}, {label.x + half, label.y + 0.6 * size}, palette::white);
            drawing_.text({{label.x, label.y + 0.35 * size}, percent, size, palette::rim, Anchor::middle});
        }
    }
    void petals(const Bins& share, Colour colour) {
        for (std::size_t i = 0; i < 2 * share.size(); ++i) {
            std::vector<Pixel> petal{centre_};
            add_rim(petal, share, i);
            drawing_.polygon(petal, colour);
        }
    }
    void outline(const Bins& share) {
        std::vector<Pixel> line;
        for (std::size_t i = 0; i < 2 * share.size(); ++i) add_rim(line, share, i);
        line.push_back(line.front());
        drawing_.polyline(line, 2.5, palette::pre_existing);
    }
    void caption(const std::string& text) {
        drawing_.text({{centre_.x, centre_.y + radius_ + 44}, text, letters::text, palette::ink, Anchor::middle});
    }

private:
    /// Adds the arc at the end of a bin.
    void add_rim(std::vector<Pixel>& line, const Bins& share, std::size_t bin) const {
        for (int k = 0; k <= 5; ++k) {
            const double turn = std::numbers::pi * (static_cast<double>(bin) + k / 5.0) / Rosette::n_bins;
            line.push_back(at(turn, share[bin % share.size()]));
        }
    }
    [[nodiscard]] Pixel at(double turn, double share) const {
        const double r = radius_ * share / scale_;
        return {centre_.x + r * std::cos(turn), centre_.y - r * std::sin(turn)};
    }
    Drawing& drawing_;
    Pixel centre_;
    double radius_;
    double scale_;
};

}  // namespace

Drawing draw_rosette(const Rosette& rosette, const std::string& title, const std::string& run, const std::string& definition,
                     const PictureStyle& style) {
    if (total(rosette.tensile) + total(rosette.shear) == 0) {
        throw InputError(run + ": no micro-cracks; a rosette needs a run with some");
    }
    const Bins facet = shares(rosette.facet);
    double scale = *std::max_element(facet.begin(), facet.end());
    for (const Bins& lengths : {shares(rosette.tensile), shares(rosette.shear)}) {
        scale = std::max(scale, *std::max_element(lengths.begin(), lengths.end()));
    }
    const double step = rings_within(scale).front();
    scale = step * std::ceil(scale / step);  // no petal goes beyond the last ring
    Drawing drawing(static_cast<int>(style.page_width), 0);
    const TextColumn column{page_margin, drawing.width() - page_margin};
    const ChartText text{style.title.empty() ? title : style.title,
                         {"share of crack length by direction, in bins of 10°; load is vertical"}};
    const double top = draw_heading(drawing, text, column, 14) + 20;
    const double radius = std::min(0.225 * drawing.width(), 300.0);
    double x = 0.26 * drawing.width();
    for (const bool tensile : {true, false}) {
        const Bins& lengths = tensile ? rosette.tensile : rosette.shear;
        Rose rose(drawing, {x, top + radius}, radius, 1.02 * scale);
        rose.rings();
        rose.petals(shares(lengths), tensile ? palette::tensile : palette::shear);
        rose.outline(facet);
        rose.scale_labels();
        rose.caption(fmt::format("{}: {:.4g} mm", tensile ? "tensile" : "shear", 1e3 * total(lengths)));
        x += 0.48 * drawing.width();
    }
    const LegendEnd end = draw_legend(drawing,
                                      {{Stroke{palette::pre_existing, 2.5}, "the specimen's own facets"},
                                       {Stroke{palette::outline, 1.4}, "rings: share of the length"}},
                                      column, top + 2 * radius + 64);
    drawing.set_height(draw_heading(drawing, {"", {definition}}, column, end.bottom) + 14);
    return drawing;
}

}  // namespace graincrack
