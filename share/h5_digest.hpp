// Digest of the content of a file.
#pragma once

#include <hdf5.h>

#include <string>

namespace graincrack::h5 {

/// SHA-256 (hex) over every path, type, shape, attribute and value below the root, except the object `left_out`.
/// \throws InputError for the first object that cannot be read
/// \param reads_variable whether the file may hold texts of variable length
std::string digest(hid_t file, const std::string& file_name, const std::string& left_out, bool reads_variable);

}  // namespace graincrack::h5
