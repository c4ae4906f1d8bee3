// From triangles to an assemblage: grains with nodes of their own and constant-strain triangles (CST) inside, contacts between
// them, boundary edges around them.
#pragma once

#include <cstdint>

#include "mesher/point_relaxation.hpp"
#include "mesher/shape.hpp"
#include "share/specimen.hpp"

namespace graincrack::mesher {

/// Sizes of an assemblage of triangular grains.
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

/// Makes every triangle a grain of n × n elements.
///
/// Grains follow a Hilbert curve of their centroids; nodes and elements follow their grains; contacts are ordered by
/// (grain a, grain b), those of one grain boundary along a1→a2; boundary edges run round the outline from its first point.
/// Sets shape, sizes and arrays; the caller sets seed and statistics.
/// \throws UsageError if the arrays would need more than 2³¹ − 1 nodes
Specimen build_assemblage(const Shape& shape, const Outline& outline, const PlaneMesh& mesh, int elements_per_edge);

}  // namespace graincrack::mesher
