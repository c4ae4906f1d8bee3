// The two columns of a report: what was fitted, what was predicted.
#pragma once

#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/report/test_report.hpp"
#include "share/material.hpp"

namespace graincrack {

/// Fitted: what [fitted] of the material names. Predicted: everything else. One column if the material has no [fitted].
/// Each with mean, standard deviation, 95 % interval and, if a material is given, the laboratory's value.
/// \param envelope of the set, if it has one
std::string comparison_columns(const std::vector<TestReport>& tests, const std::optional<Envelope>& envelope,
                               const std::optional<Material>& material);

}  // namespace graincrack
