// Picture of a specimen: its grains by phase, its rim, its pre-existing cracks.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/command.hpp"
#include "share/specimen.hpp"

namespace graincrack {

Drawing draw_specimen(const Specimen& specimen);

Command specimen_plot();

}  // namespace graincrack
