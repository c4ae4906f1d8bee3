// The command `view` writes runs as a page in which a browser steps through the frames of tests.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "share/base/progress.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

struct ViewOptions {
    CrackLabelChoice label = {};  ///< label of all cracks of the page
    int frames = 25;              ///< most frames per run; 2 for the peak and the end
};

/// Chooses from n frames, ascending: all if they are no more than `most`, else evenly spaced ones with the first, the last and
/// `kept`; with `most` = 2, the last and `kept`. \pre most ≥ 2, kept < n
std::vector<std::size_t> evenly_chosen(std::size_t n, std::size_t most, std::size_t kept);

/// The data of a run in a page.
struct ViewedRun {
    std::string json;  ///< input of `map.js`; no HTML tag begins in it
    std::size_t frames = 0;
};
/// Reads a run for a page. \throws InputError if the run cannot be read or has no frames
ViewedRun viewed_run(const RunReader& run, const ViewOptions& options);
/// The data of runs and the script that draws their maps, for the end of a page.
std::string map_scripts(const std::vector<ViewedRun>& runs);

/// Returns the page, which needs no other file: specimen, minerals, cracks, displacements and stresses of each run in each frame,
/// its load curve with the default thresholds, and the script that draws them. \throws InputError as `viewed_run`
std::string make_view(const std::vector<std::string>& runs, const ViewOptions& options, Verbosity verbosity);

}  // namespace graincrack
