// Opens files and their images for reading. Included by share/h5_*.cpp only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "share/file/h5_detail.hpp"

namespace graincrack::h5 {

/// All bytes of stdin. \throws InputError
std::vector<char> read_stdin();

/// Opens a file image; an invalid handle if it is none. \throws InputError if it is empty
Handle open_image(const std::vector<char>& bytes);
/// Opens a file; an invalid handle if it is no HDF5 file. \throws InputError if there is no such file that can be read
Handle open_path(const std::string& path);

bool has_hdf5_signature(const char* bytes, std::size_t size);
bool file_has_hdf5_signature(const std::string& path);
/// Throws the error for an unreadable file: one with the HDF5 signature is truncated or damaged, any other is no HDF5 file.
[[noreturn]] void throw_unreadable(const std::string& name, bool has_signature);

}  // namespace graincrack::h5
