// The command `envelope`: strength criteria fitted to a set of tests.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/command.hpp"
#include "post/fit/envelope.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// One row for the set of runs. If capped runs are accepted, their number stands in the row and a line on `notes` says so.
/// \throws InputError as collect_envelope_tests and fit_envelope
void write_envelope_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, CappedRuns capped_runs,
                          std::ostream& notes);

Command envelope_command();

}  // namespace graincrack
