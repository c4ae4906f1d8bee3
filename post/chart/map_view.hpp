// A map of a specimen on a page: title above, grains in their place, legend and scale below.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/drawing.hpp"
#include "share/run_file.hpp"

namespace graincrack {

using Positions = std::vector<std::array<double, 2>>;

/// Where the nodes are in a frame, displacements magnified.
Positions moved_nodes(const Specimen& specimen, const Frame& frame, double magnification);

/// The colour of a grain: by phase unless another function is given.
using GrainColour = std::function<Colour(std::size_t grain)>;

/// One entry of the legend: a stroke and what it means.
struct LegendEntry {
    Colour colour;
    double width = 4;
    std::string label;
};

/// How large the page of a map is, in pixels.
struct MapPage {
    double width = 1000;
    double largest_height = 1400;  ///< of the map itself
    double margin = 40;
    double title_size = 31;
    double text_size = 25;
    double legend_height = 80;  ///< 0 for a page without legend
};

class MapView {
public:
    /// Lays the page out so that the specimen, and what moved out of it by up to a tenth of its size, fits tightly.
    ///
    /// \param positions place of each node, m \param title first line bold
    MapView(const Specimen& specimen, Positions positions, const std::vector<std::string>& title, const MapPage& page = {});

    /// Fills the grains and draws their outlines, unless they are too small for that, and the rim.
    void draw_grains(const GrainColour& colour = {});
    /// Contacts that start broken. \return whether there are any
    bool draw_pre_existing_cracks(double width);
    /// A stroke between two places; left out if its middle lies off the map.
    void stroke(std::array<double, 2> from, std::array<double, 2> to, double width, Colour colour);
    /// A rigid platen on the specimen's axis: a bar from −half_width to half_width, above or below the height y; m.
    void draw_platen(double y, bool above, double half_width);
    /// Legend and a scale bar below the map, and below them a line of text, unless it is empty.
    void draw_legend(const std::vector<LegendEntry>& entries, const std::string& note = {});

    [[nodiscard]] const Positions& positions() const { return positions_; }
    [[nodiscard]] double pixels_per_metre() const { return scale_; }
    /// Moves the finished page out of the map.
    [[nodiscard]] Drawing drawing() && { return std::move(drawing_); }

private:
    struct Layout;
    MapView(const Specimen& specimen, Positions&& positions, const std::vector<std::string>& title, const MapPage& page,
            const Layout& layout);
    /// Calls `draw` with the corners of each triangle on the map and its colour.
    template <class Draw>
    void each_grain(const GrainColour& colour, const Draw& draw) const;
    void draw_small_grains(const GrainColour& colour);
    [[nodiscard]] Pixel pixel(std::array<double, 2> place) const;
    [[nodiscard]] bool visible(std::array<double, 2> place) const;
    void draw_outline(std::int32_t from, std::int32_t to, double width, Colour colour);

    const Specimen& specimen_;
    Positions positions_;
    MapPage page_;
    std::array<double, 2> low_;  ///< corners of the map, m
    std::array<double, 2> high_;
    double scale_;  ///< pixels per m
    Pixel origin_;  ///< where the lower left corner of the map is
    Drawing drawing_;
};

}  // namespace graincrack
