// The table of strengths with the checks of their runs: one row a run.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "post/measure/strength.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Writes the table `strength`, whose columns are those of share/doc/columns.tsv; all runs are measured before the first row is
/// written. \param kind of the strength that strains, cracks, loads and the terminal belong to: the first peak of a compression
/// test, or the largest stress \param options of graincrack-mesh and graincrack-solve, each one or several with commas between,
/// whose values in the runs are further columns \throws UsageError for one that no run has \param diagnostics gets, after the
/// table, a line for each reason to doubt the strength of a run, and one if direct tension is stronger than the Brazilian test
void write_strength_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, std::ostream& diagnostics,
                          StrengthKind kind = StrengthKind::first_peak, ColumnChoice columns = ColumnChoice::all,
                          const std::vector<std::string>& options = {});

}  // namespace graincrack
