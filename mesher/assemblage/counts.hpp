// Sizes of an assemblage of triangular grains, and of its file.
#pragma once

#include <cstdint>

namespace graincrack::mesher {

struct AssemblageCounts {
    std::int64_t grains = 0;
    std::int64_t nodes = 0;
    std::int64_t elements = 0;
    std::int64_t contacts = 0;
    std::int64_t boundary_edges = 0;
};

/// Counts for `n_grains` triangles with `n_boundary` of their sides on the boundary and n × n elements each.
AssemblageCounts assemblage_counts(std::int64_t n_grains, std::int64_t n_boundary, int elements_per_edge);

/// Bytes of the arrays of a specimen file before compression.
std::int64_t uncompressed_size(const AssemblageCounts& counts);

}  // namespace graincrack::mesher
