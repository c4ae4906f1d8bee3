// Contours of response surfaces over two factors, with the optimum and its joint confidence region.
#pragma once

#include "post/ccd/tables.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// The first two factors; further ones are held at the optimum. \throws InputError with one factor
Drawing draw_surface(const ccd::Problem& problem, const PictureStyle& style = {});

Command surface_plot();

}  // namespace graincrack
