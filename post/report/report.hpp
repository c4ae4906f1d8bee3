// The command `report` writes a test or a set of tests as one self-contained HTML page.
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
    std::optional<Material> material = {};  ///< for laboratory values and fractions of phases; empty for that of the first run
    CrackLabelChoice label = {};            ///< label of all cracks of the page
};

/// Returns the page: curve, crack map and envelope at a glance; properties against the laboratory; means over seeds; curves,
/// quality checks, envelope, maps, energy balance, parameters, provenance. Runs are read one by one; the first run of each test
/// and confining pressure has maps. An envelope needs runs with first peaks. A test of a specimen that is given twice counts
/// once, and values of a material other than that of the runs are left out. \param diagnostics gets a line on each of these two,
/// and the notes on the material \throws InputError if a run cannot be read or evaluated, or if the runs are not of one material
std::string make_report(const std::vector<std::string>& runs, const ReportOptions& options, Verbosity verbosity,
                        std::ostream& diagnostics);

}  // namespace graincrack
