// Crack map of a run at one time: grains where they moved to, tensile cracks red, shear cracks black.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/plot/make_plot.hpp"
#include "post/run/crack_label.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// Which state is drawn, and how.
struct CrackMapOptions {
    std::string frame = "last";  ///< as `choose_frames` reads it: several are drawn side by side
    std::optional<double> time;  ///< s
    double magnification = 1;    ///< of the displacements
    CrackLabelChoice label = {};
    std::vector<std::string> classes = {};  ///< of the contacts whose cracks are drawn, as `contacts_of_classes` reads them
    double largest_height = 1400;           ///< of a single map without its texts, pixels of the page
};

/// \throws InputError, UsageError as `choose_frames`, `read_labelled_cracks` and `contacts_of_classes`
Drawing draw_cracks(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style = {});

/// Options of a map of one or several frames.
struct MapPlotOptions : PlotOptions {
    CrackMapOptions map;
};
void add_map_options(OptionSet set, MapPlotOptions& options);

Command cracks_plot();

}  // namespace graincrack
