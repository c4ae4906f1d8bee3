// The mesh of a specimen in the form of other programs, with points shared by grains, and as text in MSH 2.2 of Gmsh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack {

/// A named side of triangles.
struct NamedSide {
    std::int32_t from = 0;
    std::int32_t to = 0;
    std::size_t name = 0;  ///< index into `SharedMesh::side_names`
};

/// Triangles of grains with shared points.
struct SharedMesh {
    std::vector<std::array<double, 2>> points;           ///< each point once, in the order of their lowest nodes, m
    std::vector<std::array<std::int32_t, 3>> triangles;  ///< points; order and corners as in the elements
    std::vector<std::int32_t> triangle_grain;            ///< ascending from 0
    std::vector<std::int32_t> grain_crystal;             ///< from 0; the grain if each crystal is one grain
    std::vector<std::uint8_t> grain_phase;               ///< index into phase_names
    std::vector<std::string> phase_names;
    /// The boundary in order, solid on the left, followed by the contacts, in order, that were broken before a test or belong to
    /// a class of flaws, from a1 to a2.
    std::vector<NamedSide> sides;
    /// Names in use: parts of the boundary by number, `crack`, and for each class of flaws `flaw-NAME` (intact) and
    /// `flaw-NAME-broken`.
    std::vector<std::string> side_names;
    bool has_strength_factors = false;  ///< of contacts; meshes have none
    bool has_crystals = false;          ///< true if crystals have several grains and are entities in their place
    std::uint64_t seed = 0;             ///< seed of the specimen
};

/// Makes the shared mesh of a specimen. Nodes joined by contacts are one point, which has the position of the lowest node.
SharedMesh share_nodes(const Specimen& specimen);

/// Writes MSH 2.2 ASCII. Triangles have the numbers of elements, from 1, and the tags phase + 1 and crystal + 1. Lines follow,
/// with tags beyond those of phases and crystals. Coordinates are in m, in the fewest digits that read back exactly. Names have
/// no quotes and control characters.
std::string gmsh_text(const SharedMesh& mesh);

/// The content of a mesh that the format lacks, or has by another name: "leaves out strength factors of contacts", …
std::vector<std::string> losses(const SharedMesh& mesh);

}  // namespace graincrack
