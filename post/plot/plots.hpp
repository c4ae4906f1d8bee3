// The pictures of `plot`: one drawing function each, in the order of --help.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/ccd/tables.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/picture.hpp"
#include "post/chart/picture_style.hpp"
#include "post/cracks/rosette.hpp"
#include "post/fit/envelope.hpp"
#include "post/fit/size_effect.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/load_curve.hpp"
#include "share/base/events.hpp"
#include "share/file/run_file.hpp"
#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"
#include "solver/law/table.hpp"

namespace graincrack {

/// Draws grains coloured by phase, and contacts that start broken.
Drawing draw_specimen(const Specimen& specimen, const PictureStyle& style = {});

/// Draws axial stress (positive in the sense of the test; brazilian: 2F/(πtD)) against axial strain to the right and lateral
/// strain to the left, from platens and boundary. A triangle marks a first peak below the largest stress, a short line the
/// residual strength. A single run has the counts of its micro-cracks on a second scale.
/// \throws InputError if brazilian, tension and compression runs are mixed, because their stresses have different meanings
/// \param definition definition in words of the cracks that the histories count \param caveats caveats of the strength, one per
/// line
Drawing draw_curves(const std::vector<RunData>& runs, const std::string& definition, const std::vector<std::string>& caveats = {},
                    const PictureStyle& style = {});

/// The quantity that colours the grains of a map: mineral, greatest or least compression in the plane, displacement.
enum class MapFill { mineral, sigma1, sigma3, displacement };

/// The state in a map, and its form.
struct CrackMapOptions {
    std::string frame = "last";  ///< frames as `choose_frames` reads them; several are side by side
    std::optional<double> time;  ///< s
    double magnification = 1;    ///< magnification of the displacements
    CrackLabelChoice label = {};
    double largest_height = 1400;  ///< height of a single map without its texts, pixels of the page
    MapFill fill = MapFill::mineral;
};

/// Draws a map of cracks. \throws InputError, UsageError as `choose_frames` and `read_labelled_cracks`
Drawing draw_cracks(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style = {});

/// Writes all frames as numbered pictures of one size and scale into a folder.
/// \throws UsageError for the name of a file, InputError as `draw_cracks`, OutputError as `write_picture_folder`, Interrupted
void write_frames(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style, const std::string& folder,
                  const PictureSize& size, Verbosity verbosity);

/// Draws two roses, tensile and shear. Petals show fractions of the length of cracks in bins of 10°, and the line behind them the
/// fractions of the specimen's facets. The length of a petal is its fraction; orientations have no sense, so both halves are
/// equal.
/// \throws InputError without cracks
/// \param definition definition of its cracks in words
Drawing draw_rosette(const Rosette& rosette, const std::string& title, const std::string& run, const std::string& definition,
                     const PictureStyle& style = {});

/// Draws the terms of the energy balance over a test, per metre of thickness, and the place of its largest stress; the subtitle
/// has the largest residual. Terms below a thousandth of the largest are named only.
Drawing draw_energy(const RunData& run, const PictureStyle& style = {});

/// Draws thresholds as laboratories do (Martin & Chandler 1994). The upper chart has the stress over axial (to the right),
/// lateral (to the left) and volumetric strain, ε1 + 2 ε3, with level lines at CI and CD. The lower chart has, over the axial
/// strain, the volumetric strain, whose largest value gives CD, and the crack volumetric strain, whose onset gives CI. Strains
/// are those of the gauges since the start of axial loading. Limits of the style apply to the upper chart.
/// \throws InputError unless it is a compression test
Drawing draw_thresholds(const RunData& run, const PictureStyle& style = {});

/// Draws Mohr half circles of all tests, with one colour per confining pressure: for tension from −σt to 0, for brazilian tests
/// at the centre of the disc from −σt to 3σt. Mohr–Coulomb is a line, Hoek–Brown (compression only) a dashed curve.
Drawing draw_envelope(const EnvelopeTests& tests, const std::string& title, const PictureStyle& style = {});

/// Draws each run as a point, each series with its power law (log–log) and, for tensile strengths, the slope of the theory.
Drawing draw_size_effect(const std::vector<SizeSeries>& series, const PictureStyle& style = {});

/// Draws a response surface over the first two factors, with further ones at the optimum. \throws InputError with one factor
Drawing draw_surface(const ccd::Problem& problem, const PictureStyle& style = {});

/// The choice of curves of the laws.
struct LawPlotOptions {
    std::vector<std::string> laws;                        ///< names; empty: that of the material
    bool all = false;                                     ///< all laws in addition to that of the material
    double normal_stress = 20e6;                          ///< compression under which a contact is sheared, Pa
    std::string own = std::string(name_of(default_law));  ///< law of the material, whose curve is black
};

/// Draws laws in charts below one another, or side by side on a wide page: traction against opening with an unloading half-way
/// down, the same near the peak, and shear traction against sliding of an open contact (δn = 0, solid) and of one under
/// compression (dashed). \throws UsageError for an unknown law
Drawing draw_laws(const ContactParameters& contact, const std::string& title, const LawPlotOptions& options,
                  const PictureStyle& style = {});

/// Draws P(z)/X = a [(ζ/z)^n − (ζ/z)^m] (Eqs 20–22), its slope and b for the corners and the middle (m, n) of Table 9.
Drawing draw_lennard_jones(const PictureStyle& style = {});

struct TablePlotOptions {
    std::string x;
    std::vector<std::string> y;
    bool points = false;  ///< points instead of lines
};

/// Draws one curve for each column y of each table. \throws InputError for a missing column or one without numbers
Drawing draw_tables(const std::vector<std::string>& files, const TablePlotOptions& options, const PictureStyle& style = {});

}  // namespace graincrack
