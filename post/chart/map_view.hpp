// Draws a map of a specimen on a page: title above, grains in the middle, legend and scale below.
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

/// Positions of the nodes in a frame with magnified displacements, m.
Positions moved_nodes(const Specimen& specimen, const Frame& frame, double magnification);

/// Legend of the colours of the phases; empty for one phase.
std::vector<LegendEntry> phase_legend(const Specimen& specimen);

/// A rectangle in the plane, m.
struct MapBox {
    std::array<double, 2> low{1e300, 1e300};
    std::array<double, 2> high{-1e300, -1e300};
    void include(const MapBox& other);
};
/// Bounds of the moved nodes, at most a tenth beyond the specimen at rest: ejected fragments are left out.
MapBox view_box(const Specimen& specimen, const Positions& positions);

/// Size of a map on its page.
struct MapScale {
    double width = 1;  ///< width of the map, m
    double pixels_per_metre = 1;
};
/// Draws a scale bar of a round length at the right, beside a legend's last line if there is room. \param end end of the legend
/// \return bottom of both, pixels
double draw_scale_bar(Drawing& page, const MapScale& scale, const TextColumn& column, const LegendEnd& end);

/// Colours of values: white at 0, blue above and orange below, darkest at the magnitude of the larger end, as for stresses on the
/// page of `view`.
struct ColourScale {
    std::string label;  ///< label with the unit: "displacement, mm"
    double low = 0;
    double high = 0;

    [[nodiscard]] Colour of(double value) const;
    /// Widens the range to hold all values except a hundredth at each end, which would leave the others pale.
    void include(std::vector<double> values);
    /// Draws the label, and below it the colours with round numbers. \return their bottom, pixels
    double draw(Drawing& page, const TextColumn& column, double top) const;
};

/// The parts of a page around its map.
struct MapPage {
    PictureStyle style = {};
    double largest_height = 1400;  ///< largest height of the map itself, pixels
    double margin = page_margin;
    double heading_height = 0;                ///< least height, so that maps side by side align
    std::optional<MapBox> view = {};          ///< region drawn, for maps of one scale; missing: the bounds of the positions
    std::optional<ColourScale> colours = {};  ///< colours of values that replace those of minerals
};

class MapView {
public:
    /// Lays out the page tightly around the visible content.
    ///
    /// \param positions of the nodes, m
    MapView(const Specimen& specimen, Positions positions, const ChartText& text, const MapPage& page = {});

    /// Fills the grains and draws the rim and, unless grains are too small, their outlines, thinner within crystals.
    /// \param values of the elements, if the page has colours of values
    void draw_grains(const std::vector<double>& values = {});
    /// Draws contacts that start broken or, lighter, intact contacts of flaws. \return false if there are none
    bool draw_flaws(double width, bool are_broken);
    /// Draws a stroke between two places, m, unless its middle is outside the map.
    void stroke(std::array<double, 2> from, std::array<double, 2> to, double width, Colour colour);
    /// Draws platens, rollers or punches as a bar outside each face, moved by `approach`, m.
    void draw_platens(const PlatenFaceSet& set, double approach);
    /// Draws colours of values, legend and scale bar below the map, then lines of text.
    void draw_legend(const std::vector<LegendEntry>& entries, const std::vector<std::string>& notes = {});

    [[nodiscard]] const Positions& positions() const { return positions_; }
    [[nodiscard]] MapScale scale() const { return {high_[0] - low_[0], scale_}; }
    [[nodiscard]] double pixels_per_metre() const { return scale_; }
    /// Moves the finished page out of the object.
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
    Pixel origin_;      ///< place of the lower left corner of the map
    Drawing drawing_;
};

/// True if the test has platens; direct tension pulls at the ends of the specimen.
bool has_platens_to_draw(const RunData& run);
bool has_pre_existing_cracks(const Specimen& specimen);

/// Draws older cracks and those of the test: tensile above shear, thin within crystals.
void draw_cracks(MapView& map, const Specimen& specimen, const std::vector<Crack>& present);

/// The number of contacts with cracks of a mode, for a legend.
std::string cracked_contacts(const std::vector<Crack>& cracks, CrackMode mode);
/// The definition of the cracks of a picture in lines.
std::vector<std::string> crack_notes(const Specimen& specimen, const CrackLabel& label);

}  // namespace graincrack
