// What is in a file, for a person: kind, attributes, counts, datasets; and its digest.
#pragma once

#include <iosfwd>
#include <string>

namespace graincrack {

/// Prints kind, attributes, counts and the list of datasets of a specimen or run.
/// \param check also reads every dataset and validates the specimen \throws InputError
void write_info(std::ostream& out, const std::string& path, bool check);

/// Prints `digest  file`, as sha256sum does. \throws InputError
void write_digest(std::ostream& out, const std::string& path, bool check);

}  // namespace graincrack
