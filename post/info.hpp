// What is in a file, for a person: kind, attributes, counts, datasets; and its digest.
#pragma once

#include <iosfwd>
#include <string>

#include "post/table.hpp"
#include "share/run_file.hpp"

namespace graincrack {

/// Prints kind, attributes, counts and the list of datasets of a specimen or run.
/// \param check also reads every dataset and validates the specimen \throws InputError
void write_info(std::ostream& out, const std::string& path, bool check);

/// Prints `digest  file`, as sha256sum does. \throws InputError
void write_digest(std::ostream& out, const std::string& path, bool check);

/// Prints the history of a run: every column of /history, names with SI units, tension positive as in the file.
void write_history(std::ostream& out, const RunReader& run, TableFormat format);

}  // namespace graincrack
