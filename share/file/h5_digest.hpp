// Digest and list of the content of a file.
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

namespace graincrack::h5 {

/// SHA-256 (hex) over every path, type, shape, attribute and value below the root, except the object `left_out`.
/// \throws InputError for the first object that cannot be read
std::string digest(hid_t file, const std::string& file_name, const std::string& left_out);

/// One line for each dataset: path, type, shape, unit, description.
std::vector<std::string> describe(hid_t file, const std::string& file_name);

}  // namespace graincrack::h5
