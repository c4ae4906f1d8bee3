// Writes the section of a report that compares its runs with the laboratory.
#pragma once

#include <string>
#include <vector>

#include "post/laboratory/comparison.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// Returns a table with the columns property, laboratory, computed, difference, agreement, origin and kind, and one row per group
/// of runs that has the property. Laboratory properties without a test among the runs are "not tested". The table [fitted] of the
/// material follows. \param envelopes those of the fabrics, if they have one \param caveats paragraphs below the table
std::string comparison(const std::vector<SeedGroup>& groups, const std::vector<FabricEnvelope>& envelopes,
                       const std::optional<Material>& material, const std::string& caveats = "");

/// Returns [fitted] as a table: property, fitted to, computed on new specimens, 95 % interval, specimens; "" without it.
std::string fitted_table(const std::optional<Material>& material);

}  // namespace graincrack
