// Picture of a specimen: its grains by phase, its rim, its pre-existing cracks.
#pragma once

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/command.hpp"
#include "share/specimen.hpp"

namespace graincrack {

Drawing draw_specimen(const Specimen& specimen, const PictureStyle& style = {});

Command specimen_plot();

}  // namespace graincrack
