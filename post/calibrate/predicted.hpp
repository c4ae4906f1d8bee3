// The table [predicted] of a calibrated material: predictions for new specimens from rock type and calibration runs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "post/calibrate/report.hpp"
#include "post/kind/kind_surface.hpp"
#include "share/rock/material.hpp"

namespace graincrack::calibrate {

/// Returns the text of a material file with these predictions in place of earlier ones. \param at the material of the file
std::string with_predictions(const std::string& text, const Material& at, const std::vector<Prediction>& predictions);

/// Returns the predictions for new specimens in the file of a material, by the names of their targets; `mean_deviation` is not
/// set. Empty if contacts or grains have changed since the calibration.
std::map<std::string, KindPrediction> predictions_in(const Material& material);

}  // namespace graincrack::calibrate
