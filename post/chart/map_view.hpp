// A map of a specimen on a page: title above, grains in their place, legend and scale below.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/page.hpp"
#include "post/chart/picture_style.hpp"
#include "share/run_file.hpp"

namespace graincrack {

using Positions = std::vector<std::array<double, 2>>;

/// Where the nodes are in a frame, displacements magnified.
Positions moved_nodes(const Specimen& specimen, const Frame& frame, double magnification);

/// The colour of a grain: by phase unless another function is given.
using GrainColour = std::function<Colour(std::size_t grain)>;

/// Entries of a legend for the colours of the phases; none for grains of one kind.
std::vector<LegendEntry> phase_legend(const Specimen& specimen);

/// What a page with a map has beside it.
struct MapPage {
    PictureStyle style = {};
    double largest_height = 1400;  ///< of the map itself, pixels
    double margin = page_margin;
    double heading_height = 0;  ///< at least, so that maps side by side stand at one height
};

class MapView {
public:
    /// Lays the page out so that the specimen, and what moved out of it by up to a tenth of its size, fits tightly.
    ///
    /// \param positions place of each node, m
    MapView(const Specimen& specimen, Positions positions, const ChartText& text, const MapPage& page = {});

    /// Fills the grains and draws their outlines, unless they are too small for that, and the rim.
    void draw_grains(const GrainColour& colour = {});
    /// Contacts that start broken. \return whether there are any
    bool draw_pre_existing_cracks(double width);
    /// A stroke between two places; left out if its middle lies off the map.
    void stroke(std::array<double, 2> from, std::array<double, 2> to, double width, Colour colour);
    /// A rigid platen on the specimen's axis: a bar from −half_width to half_width, above or below the height y; m.
    void draw_platen(double y, bool above, double half_width);
    /// The boundaries between grains of different colours, dark, so that they stay apart in grey.
    void draw_boundaries(const std::function<bool(std::size_t contact)>& is_boundary, double width);
    /// Legend and a scale bar below the map, and below them a line of text, unless it is empty.
    void draw_legend(const std::vector<LegendEntry>& entries, const std::string& note = {});

    [[nodiscard]] const Positions& positions() const { return positions_; }
    [[nodiscard]] double pixels_per_metre() const { return scale_; }
    /// Moves the finished page out of the map.
    [[nodiscard]] Drawing drawing() && { return std::move(drawing_); }

private:
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
    double scale_ = 1;  ///< pixels per m
    Pixel origin_;      ///< where the lower left corner of the map is
    Drawing drawing_;
};

}  // namespace graincrack
