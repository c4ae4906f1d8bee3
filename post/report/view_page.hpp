// The command `view`: runs as a page in which tests are turned over in the browser.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "share/base/progress.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

struct ViewOptions {
    CrackLabelChoice label = {};  ///< of all cracks of the page
    int frames = 25;              ///< most of a run that the page holds; 2: at the peak and the last
};

/// Some of n frames, ascending: all if they are no more than `most`, else evenly chosen ones with the first, the last and one
/// that is kept; of at most two the last and the one that is kept. \pre most ≥ 2, kept < n
std::vector<std::size_t> evenly_chosen(std::size_t n, std::size_t most, std::size_t kept);

/// What a page holds of a run.
struct ViewedRun {
    std::string json;  ///< as `map.js` reads it, in which no tag begins
    std::size_t frames = 0;
};
/// \throws InputError if the run cannot be read or has no frames
ViewedRun viewed_run(const RunReader& run, const ViewOptions& options);
/// The data of runs and the script that draws maps of them, for the end of a page.
std::string map_scripts(const std::vector<ViewedRun>& runs);

/// The page, which needs no other file: specimen, minerals, cracks, displacements and stresses of each run in each of its frames,
/// its load curve with the default thresholds, and the script that draws them. \throws InputError if a run cannot be read or has
/// no frames
std::string make_view(const std::vector<std::string>& runs, const ViewOptions& options, Verbosity verbosity);

}  // namespace graincrack
