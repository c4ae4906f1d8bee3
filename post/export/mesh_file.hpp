// The mesh of a specimen as other programs have meshes, whose grains share points, and as text: MSH 2.2 of Gmsh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack {

/// A side of triangles with a name.
struct NamedSide {
    std::int32_t from = 0;
    std::int32_t to = 0;
    std::size_t name = 0;  ///< index into `SharedMesh::side_names`
};

/// Triangles of grains that share their points.
struct SharedMesh {
    std::vector<std::array<double, 2>> points;           ///< m; each once, in the order of their lowest nodes
    std::vector<std::array<std::int32_t, 3>> triangles;  ///< points, in the order and with the corners of the elements
    std::vector<std::int32_t> triangle_grain;            ///< ascending from 0
    std::vector<std::int32_t> grain_crystal;             ///< from 0; without crystals of several grains the grain
    std::vector<std::uint8_t> grain_phase;               ///< index into phase_names
    std::vector<std::string> phase_names;
    /// The boundary in its order, solid on the left; then, in the order of contacts, those that were broken before a test or
    /// belong to a class of flaws, from a1 to a2.
    std::vector<NamedSide> sides;
    /// Those in use: parts of the boundary by their number, `crack`, and for each class of flaws `flaw-NAME`, where it holds, and
    /// `flaw-NAME-broken`.
    std::vector<std::string> side_names;
    bool has_strength_factors = false;  ///< of contacts, which no mesh carries
    bool has_crystals = false;          ///< of several grains, which are entities in place of grains
    std::uint64_t seed = 0;             ///< of the specimen
};

/// The shared mesh of a specimen. Nodes are one point if contacts join them; it lies where the lowest of them does.
SharedMesh share_nodes(const Specimen& specimen);

/// MSH 2.2 ASCII. Triangles are numbered as elements are, from 1: their tags are phase + 1 and crystal + 1. Lines follow, with
/// tags beyond those of the phases and the crystals. Coordinates in m, in the fewest digits that read back exactly.
/// Names are written without quotes and control characters.
std::string gmsh_text(const SharedMesh& mesh);

/// The parts of a mesh that the format does not carry, or carries by another name: "leaves out strength factors of contacts", …
std::vector<std::string> losses(const SharedMesh& mesh);

}  // namespace graincrack
