// The report of a calibration, in Markdown.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "post/calibrate/decide.hpp"

namespace graincrack::calibrate {

/// \param rock as it was given \param at the same with the values found, if there are any \param n_runs that are finished
std::string report_text(const Material& rock, const std::optional<Material>& at, const Problem& problem, const Decision& decision,
                        std::size_t n_runs);

/// "25.8 (25.5 to 26.1)"
std::string with_interval(const Estimate& estimate, double si);

}  // namespace graincrack::calibrate
