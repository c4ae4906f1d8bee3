// Chunks of HDF5 datasets as the library's filters shuffle and deflate make them, but faster.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace graincrack::h5 {

/// Shuffles the bytes of a chunk (all first bytes of its items, then all second ones, and so on) and deflates them (RFC 1950)
/// with repeated bytes as the only matches (Z_RLE of zlib), which is faster than the library's deflate filter, and readable by
/// it. \param bytes of whole items \throws OutputError without memory
std::vector<unsigned char> deflated_chunk(std::span<const unsigned char> bytes, std::size_t item_bytes);

}  // namespace graincrack::h5
