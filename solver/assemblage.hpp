// The assemblage as the kernels see it: constant data in structures of arrays, grains in the order of the specimen,
// cut into blocks that one thread works on at a time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "share/fracture_process_zone.hpp"
#include "share/specimen.hpp"
#include "solver/element.hpp"
#include "solver/outline.hpp"
#include "solver/vector2.hpp"

namespace graincrack {

/// Most contacts in a block.
inline constexpr std::int32_t contacts_per_block = 128;

/// A half-open range of indices.
struct Range {
    std::int32_t begin = 0;
    std::int32_t end = 0;
    [[nodiscard]] std::int32_t size() const { return end - begin; }
};

/// A contact's constant geometry.
struct ContactGeometry {
    std::array<std::int32_t, 4> nodes;  ///< a1 a2 b1 b2
    Vector2 edge;                       ///< a1 → a2 in the reference, m
    double point_area;                  ///< of one of its two points: half the edge × 1 m, m²
};

/// A group of grains with their elements and nodes, all contiguous; no node is shared between blocks.
struct GrainBlock {
    Range elements;
    Range nodes;
};

/// Constant data of a run. Node order: by grain, within a grain as in the specimen.
struct Assemblage {
    PlaneElasticity elasticity;
    std::vector<Vector2> position;                           ///< [n] reference, m
    std::vector<double> mass;                                ///< [n] kg per metre of thickness
    std::vector<double> inverse_mass;                        ///< [n]
    std::vector<std::array<std::int32_t, 3>> element_nodes;  ///< [e]
    std::vector<TriangleGeometry> element_geometry;          ///< [e]
    std::vector<ContactGeometry> contacts;                   ///< [c]
    std::vector<std::int32_t> slot_begin;                    ///< [n + 1] into `slots`
    std::vector<std::int32_t> slots;                         ///< contact force slots 4 c + k that act on a node, ascending
    std::vector<GrainBlock> grain_blocks;
    std::vector<Range> contact_blocks;
    std::vector<std::int32_t> node_of_specimen;  ///< [n] internal index of a node of the specimen
    Outline outline;
    double contact_length = 0;  ///< sum over contacts, m

    [[nodiscard]] std::int32_t n_nodes() const { return static_cast<std::int32_t>(position.size()); }
    [[nodiscard]] std::int32_t n_contacts() const { return static_cast<std::int32_t>(contacts.size()); }
    [[nodiscard]] std::int32_t n_elements() const { return static_cast<std::int32_t>(element_nodes.size()); }
};

/// Builds the assemblage of a validated specimen. Masses are lumped: a third of each triangle to each of its nodes.
Assemblage make_assemblage(const Specimen& specimen, const Rock& rock, PlaneCondition plane);

/// Below a fifth of its length a mid-edge (of the two facing edges) has lost its direction: the grains have turned by over
/// 150° to each other and face each other no more. Compared as squares.
inline constexpr double lost_frame = 0.04;

}  // namespace graincrack
