// Options that many commands of graincrack-post share.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/options/command.hpp"
#include "post/table/table.hpp"
#include "share/rock/incomplete_material.hpp"

namespace graincrack {

/// --format table|tsv|jsonl
void add_format(OptionSet set, TableFormat& format);
/// The same, left empty unless it is given: aligned on a terminal, TSV elsewhere (`format_for`).
void add_format(OptionSet set, std::optional<TableFormat>& format);
TableFormat format_for(const std::optional<TableFormat>& format, const std::ostream& out);
/// -o, --output, which is required. \param help what is written
void add_output(OptionSet set, std::string& output, const std::string& help);
/// --material of a command that shows laboratory values of a rock beside results.
Option add_laboratory_material(OptionSet set, std::string& material);
/// The material of an option; notes on its values go to the diagnostics of the call. \throws InputError as `read_material`
Material read_material_of(const Call& call, const std::string& name_or_file);
/// The same of a material that may lack keys.
IncompleteMaterial read_incomplete_material_of(const Call& call, const std::string& name_or_file);

}  // namespace graincrack
