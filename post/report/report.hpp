// The command `report`: a test or a set as one self-contained HTML page.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "share/base/progress.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

struct ReportOptions {
    std::optional<Material> material = {};  ///< for laboratory values and fractions of phases; default: that of the first run
    CrackLabelChoice label = {};            ///< of all cracks of the page
};

/// The page: curve, crack map and envelope at a glance; properties against the laboratory; means over seeds; curves, quality
/// checks, envelope, maps, energy balance, parameters, provenance. Runs are read one after the other; of each test and confining
/// pressure the first run has maps. An envelope is drawn only of runs with first peaks. A test of a specimen that is given twice
/// counts once. Values of another material than that of the runs are not shown. \param diagnostics gets a line on each of these
/// two, and the notes on the material \throws InputError if a run cannot be read or evaluated, or if the runs are not of one
/// material
std::string make_report(const std::vector<std::string>& runs, const ReportOptions& options, Verbosity verbosity,
                        std::ostream& diagnostics);

}  // namespace graincrack
