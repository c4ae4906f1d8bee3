// What a program's run keeps besides the history: its probes and its stages, as tables.
#pragma once

#include <ostream>
#include <string>

#include "post/table/table.hpp"
#include "share/run_file.hpp"

namespace graincrack {

/// time_s, step and every column of a probe, names with SI units. \throws InputError if the run has no such probe
void write_probe(std::ostream& out, const RunReader& run, const std::string& probe, TableFormat format);

/// stage, begin_s, end_s, ended_by: a row a stage. \throws InputError if the run is none of a program
void write_stages(std::ostream& out, const RunReader& run, TableFormat format);

}  // namespace graincrack
