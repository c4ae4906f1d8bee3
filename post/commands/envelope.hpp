// The command `envelope`: strength criteria fitted to a set of tests.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/options/command.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// One row for the set of runs. If runs stopped at the strain limit are accepted, the row holds their number and a line on
/// `diagnostics` reports it; so does a line for each run without the strength that is wanted.
/// \throws InputError as collect_envelope_tests and fit_envelope
void write_envelope_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format,
                          const EnvelopeOptions& options, std::ostream& diagnostics);

Command envelope_command();

}  // namespace graincrack
