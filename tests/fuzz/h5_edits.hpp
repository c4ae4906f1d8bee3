// Damages an HDF5 file as an input says: a list of edits of its datasets and attributes. The file stays one that the library
// itself can open, so that what is tried is what our readers make of names, types, shapes and values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace graincrack::fuzz {

/// Copies `base` to `damaged`, with the edits that `bytes` describe, twelve bytes an edit: object, kind of edit, value.
void write_damaged(const std::string& base, const std::uint8_t* bytes, std::size_t size, const std::string& damaged);

}  // namespace graincrack::fuzz
