// Crack initiation and damage on the strains that they are read from.
#pragma once

#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// Which definitions of crack initiation and damage have a mark: the default ones (`AllThresholds`), or the others too.
enum class ThresholdMarks { usual, all };

/// As laboratories draw it (Martin & Chandler 1994): above, the stress over axial (to the right), lateral (to the left) and
/// volumetric strain, ε1 + 2 ε3, with level lines at CI and CD; below, over the axial strain, the volumetric strain, at whose
/// largest value CD is read, and the crack volumetric strain, at whose onset CI is. Strains are those of the gauges since the
/// start of axial loading. Limits of the style are those of the upper chart.
/// \param cracks the log of the run, for the definitions by damage \throws InputError for a test that is no compression test
Drawing draw_thresholds(const RunData& run, ThresholdMarks marks = ThresholdMarks::usual, const PictureStyle& style = {},
                        const std::vector<Crack>& cracks = {});

Command thresholds_plot();

}  // namespace graincrack
