// The pictures of `plot`: each a function that draws it, in the order of --help.
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

/// Grains by their phase, and contacts that start broken.
Drawing draw_specimen(const Specimen& specimen, const PictureStyle& style = {});

/// Axial stress (positive in the sense of the test; brazilian: 2F/(πtD)) against axial strain to the right and lateral
/// strain to the left, both from platens and rim. A first peak below the largest stress has a triangle, the residual strength a
/// short line. One run: the counts of its micro-cracks on a second scale.
/// \throws InputError if brazilian, tension and compression runs are mixed: their stresses do not mean the same
/// \param definition of the cracks that the histories count, in words \param caveats caveats of the strength, a
/// line each
Drawing draw_curves(const std::vector<RunData>& runs, const std::string& definition, const std::vector<std::string>& caveats = {},
                    const PictureStyle& style = {});

/// What fills the grains of a map: minerals, the greatest and the least compression in the plane, displacements.
enum class MapFill { mineral, sigma1, sigma3, displacement };

/// Which state is drawn, and how.
struct CrackMapOptions {
    std::string frame = "last";  ///< as `choose_frames` reads it: several are drawn side by side
    std::optional<double> time;  ///< s
    double magnification = 1;    ///< of the displacements
    CrackLabelChoice label = {};
    double largest_height = 1400;  ///< of a single map without its texts, pixels of the page
    MapFill fill = MapFill::mineral;
};

/// \throws InputError, UsageError as `choose_frames` and `read_labelled_cracks`
Drawing draw_cracks(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style = {});

/// All frames as numbered pictures of one size and scale in a folder.
/// \throws UsageError for the name of a file, InputError as `draw_cracks`, OutputError as `write_picture_folder`, Interrupted
void write_frames(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style, const std::string& folder,
                  const PictureSize& size, Verbosity verbosity);

/// Two roses, tensile and shear: petals are shares of the length of cracks in bins of 10°, the line behind them the
/// shares of the specimen's own facets. Petals are as long as the share; an orientation has no sense, so both halves are equal.
/// \throws InputError without cracks
/// \param definition of its cracks in words
Drawing draw_rosette(const Rosette& rosette, const std::string& title, const std::string& run, const std::string& definition,
                     const PictureStyle& style = {});

/// The terms of the energy balance over a test, per metre of thickness, and where its largest stress is; the largest residual in
/// the subtitle. Terms below a thousandth of the largest are named, not drawn.
Drawing draw_energy(const RunData& run, const PictureStyle& style = {});

/// As laboratories draw it (Martin & Chandler 1994): above, the stress over axial (to the right), lateral (to the left) and
/// volumetric strain, ε1 + 2 ε3, with level lines at CI and CD; below, over the axial strain, the volumetric strain, at whose
/// largest value CD is read, and the crack volumetric strain, at whose onset CI is. Strains are those of the gauges since the
/// start of axial loading. Limits of the style are those of the upper chart.
/// \throws InputError for a test that is no compression test
Drawing draw_thresholds(const RunData& run, const PictureStyle& style = {});

/// Half circles of all tests, a colour a confining pressure; tension by its circle from −σt to 0, brazilian by that of the
/// disc's centre, from −σt to 3σt. Mohr–Coulomb as a line, Hoek–Brown (compression only) as a dashed curve.
Drawing draw_envelope(const EnvelopeTests& tests, const std::string& title, const PictureStyle& style = {});

/// Every run as a point, each series with its power law (log–log) and, for tensile strengths, the slope of the theory.
Drawing draw_size_effect(const std::vector<SizeSeries>& series, const PictureStyle& style = {});

/// The first two factors; further ones are held at the optimum. \throws InputError with one factor
Drawing draw_surface(const ccd::Problem& problem, const PictureStyle& style = {});

/// Which curves of the laws are drawn.
struct LawPlotOptions {
    std::vector<std::string> laws;                        ///< names; empty: that of the material
    bool all = false;                                     ///< every law beside that of the material
    double normal_stress = 20e6;                          ///< compression under which a contact is sheared, Pa
    std::string own = std::string(name_of(default_law));  ///< of the material, whose curve is black
};

/// Below one another, on a wide page side by side: traction against opening, with an unloading half-way down; the same near the
/// peak; shear traction against
/// sliding of an open contact (δn = 0) and of one under compression, solid and dashed. \throws UsageError for an unknown law
Drawing draw_laws(const ContactParameters& contact, const std::string& title, const LawPlotOptions& options,
                  const PictureStyle& style = {});

/// P(z)/X = a [(ζ/z)^n − (ζ/z)^m] (Eqs 20–22) and its slope for the pairs (m, n) of Table 9's corners and middle, with b.
Drawing draw_lennard_jones(const PictureStyle& style = {});

struct TablePlotOptions {
    std::string x;
    std::vector<std::string> y;
    bool points = false;  ///< instead of lines
};

/// One curve for each column y of each table. \throws InputError for a missing column or one without numbers
Drawing draw_tables(const std::vector<std::string>& files, const TablePlotOptions& options, const PictureStyle& style = {});

}  // namespace graincrack
