// Stress–strain curves of one or several runs; with one run also its cracks.
#pragma once

#include <vector>

#include "post/load_curve.hpp"
#include "post/picture/drawing.hpp"

namespace graincrack {

/// Axial stress (positive in the sense of the test; brazilian: 2F/(πtD)) against axial strain to the right and lateral
/// strain to the left, both from platens and rim. One run: the counts of its micro-cracks on a second scale.
/// \throws InputError if brazilian, tension and compression runs are mixed: their stresses do not mean the same
Drawing draw_curves(const std::vector<RunData>& runs);

}  // namespace graincrack
