// The command `report`: a test or a set as one HTML page that needs nothing else.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/measure/strength.hpp"
#include "share/progress.hpp"

namespace graincrack {

struct ReportOptions {
    std::string material;  ///< name or file, for laboratory values; "" for none
    CappedRuns capped_runs = CappedRuns::refuse;
};

/// The page: key figures, fitted and predicted, trust, curves, envelope, maps, ledger, parameters, provenance. Runs are read
/// one after the other; of each test and confining pressure the first run has maps.
/// An envelope is drawn only of runs with peaks, unless capped ones are accepted.
/// \throws InputError as its parts, or if the runs are not of one material
std::string make_report(const std::vector<std::string>& runs, const ReportOptions& options, Verbosity verbosity);

}  // namespace graincrack
