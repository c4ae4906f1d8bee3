// The outlines of the grains: every edge where a grain may meet another, and how they follow each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack {

/// An edge of a grain's outline, counter-clockwise: solid on the left.
struct SurfaceEdge {
    std::array<std::int32_t, 2> nodes;  ///< internal indices
    std::int32_t grain;
    std::int32_t contact;   ///< place of the contact whose side it is, −1 on a free face
    std::int32_t previous;  ///< edge of the same grain that ends at nodes[0], −1 if there is no single one
    std::int32_t next;      ///< edge of the same grain that begins at nodes[1], likewise
};

struct GrainSurface {
    std::vector<SurfaceEdge> edges;           ///< sides a and b of contact c of the specimen are 2 c and 2 c + 1; then free faces
    std::vector<std::int32_t> grain_of_node;  ///< [n] −1 for a node of no element
    std::vector<std::int32_t> edge_begin;     ///< [n + 1] into `edges_of_node`
    std::vector<std::int32_t> edges_of_node;  ///< outline edges that begin or end at a node
    std::vector<double> tributary;            ///< [n] length of outline a node stands for in a node–edge contact, m
    double mean_length = 0;                   ///< of the edges, m
};

/// The outline of a validated specimen whose nodes have the internal indices `node_of_specimen` and whose contacts have the
/// places `contact_of_specimen`. A node stands for half the mean of the two edges it ends: with another node of a flush face
/// opposite, that is what a bonded contact has for each of its two points.
GrainSurface make_surface(const Specimen& specimen, const std::vector<std::int32_t>& node_of_specimen,
                          const std::vector<std::int32_t>& contact_of_specimen);

}  // namespace graincrack
