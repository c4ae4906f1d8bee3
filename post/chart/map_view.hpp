// A map of a specimen on a page: title above, grains in their place, legend and scale below.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/page.hpp"
#include "post/chart/picture_style.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/load_curve.hpp"
#include "share/file/platen_faces.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

using Positions = std::vector<std::array<double, 2>>;

/// The positions of the nodes in a frame, displacements magnified.
Positions moved_nodes(const Specimen& specimen, const Frame& frame, double magnification);

/// Entries of a legend for the colours of the phases; none for grains of one kind.
std::vector<LegendEntry> phase_legend(const Specimen& specimen);

/// A rectangle of the plane, m.
struct MapBox {
    std::array<double, 2> low{1e300, 1e300};
    std::array<double, 2> high{-1e300, -1e300};
    void include(const MapBox& other);
};
/// The bounds of what moved, but no more than a tenth beyond the specimen at rest: fragments that were ejected are left out.
MapBox view_box(const Specimen& specimen, const Positions& positions);

/// How large a map is on its page.
struct MapScale {
    double width = 1;  ///< of the map, m
    double pixels_per_metre = 1;
};
/// A bar of a round length at the right of a page, beside the last line of a legend if there is room, else below it.
/// \param end of the legend \return where both end
double draw_scale_bar(Drawing& page, const MapScale& scale, const TextColumn& column, const LegendEnd& end);

/// White at 0, blue above and orange below, dark where a number has the size of the farther end: as the page of `view` has
/// stresses.
struct ColourScale {
    std::string label;  ///< with the unit: "displacement, mm"
    double low = 0;
    double high = 0;

    [[nodiscard]] Colour of(double value) const;
    /// Widens the ends to hold all values but a hundredth on each side, which would leave the others pale.
    void include(std::vector<double> values);
    /// Draws the label, and below it the colours from end to end with round numbers. \return where that ends
    double draw(Drawing& page, const TextColumn& column, double top) const;
};

/// The parts of a page beside its map.
struct MapPage {
    PictureStyle style = {};
    double largest_height = 1400;  ///< of the map itself, pixels
    double margin = page_margin;
    double heading_height = 0;        ///< at least, so that maps side by side stand at one height
    std::optional<MapBox> view = {};  ///< what is drawn, so that maps have one scale; else the bounds of the map's own positions
    std::optional<ColourScale> colours = {};  ///< of numbers that fill the grains in place of the colours of minerals
};

class MapView {
public:
    /// Lays the page out so that what is to be seen fits tightly.
    ///
    /// \param positions place of each node, m
    MapView(const Specimen& specimen, Positions positions, const ChartText& text, const MapPage& page = {});

    /// Fills the grains and draws their outlines, unless they are too small for that, those within crystals thinner, and the rim.
    /// \param values of the elements, where the page has colours of numbers
    void draw_grains(const std::vector<double>& values = {});
    /// Contacts that start broken, or, lighter, those of flaws that do not. \return whether there are any
    bool draw_flaws(double width, bool are_broken);
    /// A stroke between two places; left out if its middle lies off the map.
    void stroke(std::array<double, 2> from, std::array<double, 2> to, double width, Colour colour);
    /// Rigid platens, rollers or punches: a bar outside each face, all moved by `approach`; m.
    void draw_platens(const PlatenFaceSet& set, double approach);
    /// Colours of numbers, legend and a scale bar below the map, and below them lines of text.
    void draw_legend(const std::vector<LegendEntry>& entries, const std::vector<std::string>& notes = {});

    [[nodiscard]] const Positions& positions() const { return positions_; }
    [[nodiscard]] MapScale scale() const { return {high_[0] - low_[0], scale_}; }
    [[nodiscard]] double pixels_per_metre() const { return scale_; }
    /// Moves the finished page out of the map.
    [[nodiscard]] Drawing drawing() && { return std::move(drawing_); }

private:
    /// Calls `draw` with the corners of each triangle on the map and its colour.
    template <class Draw>
    void each_grain(const std::vector<double>& values, const Draw& draw) const;
    void draw_small_grains(const std::vector<double>& values);
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

/// Direct tension pulls at the ends of the specimen: there are no platens.
bool has_platens_to_draw(const RunData& run);
bool has_pre_existing_cracks(const Specimen& specimen);

/// Draws cracks from before the test, and those of the test: tensile above shear, thin within crystals.
void draw_cracks(MapView& map, const Specimen& specimen, const std::vector<Crack>& present);

/// The number of contacts with cracks of a mode, as a legend has it.
std::string cracked_contacts(const std::vector<Crack>& cracks, CrackMode mode);
/// The definition of the cracks of a picture in lines.
std::vector<std::string> crack_notes(const Specimen& specimen, const CrackLabel& label);

}  // namespace graincrack
