// The commands of graincrack-post: each with its options, and what it does. `plot` and `material` hold others.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/options/command.hpp"
#include "post/table/table.hpp"

namespace graincrack {

Command info_command();
Command history_command();
Command strength_command();
Command moduli_command();
Command toughness_command();
Command envelope_command();
Command properties_command();
Command size_effect_command();
Command summarize_command();
Command material_command();
Command kind_command();
Command fpz_command();
Command ccd_command();
Command calibrate_command();
Command cracks_command();
Command classes_command();
Command export_command();
Command report_command();
Command view_command();
Command plot_command();

/// Table `envelope`: one row. \throws InputError as `collect_envelope_tests`
void write_envelope_table(std::ostream& out, const std::vector<std::string>& paths, TableFormat format,
                          const EnvelopeOptions& options, std::ostream& diagnostics);

}  // namespace graincrack
