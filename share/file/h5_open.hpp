// Opens files and their images for reading, and checks them before anything in them is used: their groups and links, and whether
// what datasets and attributes declare can be stored in them at all. Included by share/file/h5_*.cpp only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "share/file/h5_detail.hpp"

namespace graincrack::h5 {

/// All bytes of stdin. \throws InputError
std::vector<char> read_stdin();

/// Opens a file image. \param name for messages \throws InputError if it is empty or cannot be opened
Handle open_image(const std::vector<char>& bytes, const std::string& name);
/// Opens a file. \throws InputError if there is no such file, or it cannot be opened
Handle open_path(const std::string& path);

/// Walks through all groups. \throws InputError for links other than hard ones, for a group that is linked more than once (one in
/// a circle is), and for groups nested deeper than any of ours
void require_tree(hid_t file, const std::string& file_name);

/// Number of values of a dataset. \throws InputError unless they are numbers, kept in this file, by filters that ours have, and
/// as many as its bytes can hold; nothing has been read then
std::size_t require_readable(hid_t dataset, const std::string& file_name, const std::string& path);

/// \throws InputError for an attribute that declares more than the file has bytes, or for texts of variable length: the
/// library keeps those apart, in what a damaged file leads it astray
void require_readable_attribute(hid_t attribute, const std::string& file_name, const std::string& object,
                                const std::string& name);

}  // namespace graincrack::h5
