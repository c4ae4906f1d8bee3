// What a calibration has come to, for programs: outcome.json (share/doc/tables.md).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "post/calibrate/report.hpp"

namespace graincrack::calibrate {

/// Names of the files written beside it, by what they are.
using OutcomeFiles = std::map<std::string, std::string>;

/// \param rock as it was given \param draws those of the report \param n_runs that are finished
std::string outcome_text(const Material& rock, const Problem& problem, const Decision& decision,
                         const std::optional<Draws>& draws, std::size_t n_runs, const OutcomeFiles& files);

}  // namespace graincrack::calibrate
