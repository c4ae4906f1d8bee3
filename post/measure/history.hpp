// The history of a run as a table, of a finished run or of one that is still being written.
#pragma once

#include <chrono>
#include <ostream>
#include <string>

#include "post/table/table.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// Every column of /history, names with SI units, tension positive as in the file.
void write_history(std::ostream& out, const RunReader& run, TableFormat format);

/// Writes the rows of a run as they appear, and ends when the run does. A run in progress is NAME.part until it is finished;
/// a finished one is written at once.
/// \param pause between two reads of the file
/// \throws InputError if there is neither, or if the run was abandoned; Interrupted
void follow_history(std::ostream& out, const std::string& name, TableFormat format,
                    std::chrono::milliseconds pause = std::chrono::milliseconds(500));

}  // namespace graincrack
