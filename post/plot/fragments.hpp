// Map of the fragments of a frame.
#pragma once

#include "post/options/command.hpp"
#include "post/plot/cracks.hpp"

namespace graincrack {

/// The largest fragment pale, the others coloured, where they moved to. \throws InputError, UsageError as `choose_frame`
Drawing draw_fragments(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style = {});

Command fragments_plot();

}  // namespace graincrack
