// Strengths of a set of runs by test, beside those of the laboratory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "post/run/load_curve.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// Every run as a point (a cross if it reached no peak), the mean of each test, confining pressure and grain size with its
/// 95 % interval, and the laboratory's value where the material has one; logarithmic, because tension and compression share the
/// axis. \throws InputError if the runs are not of one material \param caveats caveats of the strength, a line each
Drawing draw_strengths(const std::vector<RunData>& runs, const std::optional<Material>& material,
                       const std::vector<std::string>& caveats = {}, const PictureStyle& style = {});

Command strength_plot();

}  // namespace graincrack
