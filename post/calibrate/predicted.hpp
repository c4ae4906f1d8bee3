// [predicted] of a calibrated material: what new specimens have by its kind and by the runs of its calibration.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "post/calibrate/report.hpp"
#include "post/kind/kind_surface.hpp"
#include "share/rock/material.hpp"

namespace graincrack::calibrate {

/// The text of a material file with predictions in place of earlier ones. \param at the material that the file has
std::string with_predictions(const std::string& text, const Material& at, const std::vector<Prediction>& predictions);

/// Predictions of new specimens that the file of a material has, by the name of their target, without `mean_deviation`; none if
/// contacts or grains are others by now.
std::map<std::string, KindPrediction> predictions_in(const Material& material);

}  // namespace graincrack::calibrate
