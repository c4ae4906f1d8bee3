// The section of a report that compares its runs with the laboratory.
#pragma once

#include <string>
#include <vector>

#include "post/laboratory/comparison.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// The table property, laboratory, computed, difference, agreement, origin, kind; a row for each group of runs that has the
/// property. Properties of the laboratory without a test among the runs are "not tested". Below,
/// [fitted] of the material. \param envelopes of the fabrics that have one \param caveats paragraphs for below
/// the table
std::string comparison(const std::vector<SeedGroup>& groups, const std::vector<FabricEnvelope>& envelopes,
                       const std::optional<Material>& material, const std::string& caveats = "");

/// [fitted] as a table: property, fitted to, computed on new specimens, 95 % interval, number of specimens. Empty without
/// [fitted].
std::string fitted_table(const std::optional<Material>& material);

}  // namespace graincrack
