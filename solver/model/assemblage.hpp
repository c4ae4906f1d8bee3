// The assemblage as the kernels see it: constant data in structures of arrays, with grains in the order of the specimen, cut into
// chunks. A chunk is what a thread works on at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "share/fracture_process_zone.hpp"
#include "share/specimen.hpp"
#include "solver/model/element.hpp"
#include "solver/model/surface.hpp"
#include "solver/simd.hpp"
#include "solver/vector2.hpp"

namespace graincrack {

/// Most contacts in a chunk.
inline constexpr std::int32_t contacts_per_chunk = 64;

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

/// Slots of contact forces lie by chunk: [chunk][a1 a2 b1 b2][x y][contacts_per_chunk]. A slot is named by where its x is in
/// `State::contact_force`; its y is `contacts_per_chunk` farther.
inline constexpr std::int32_t slot_stride = 8 * contacts_per_chunk;
inline std::int32_t slot_of(std::int32_t contact, std::int32_t node) {
    return contact / contacts_per_chunk * slot_stride + 2 * node * contacts_per_chunk + contact % contacts_per_chunk;
}

/// Geometry of all triangles, side by side.
struct TriangleTable {
    std::vector<double> gradient1_x, gradient1_y, gradient2_x, gradient2_y, area;
    [[nodiscard]] std::size_t size() const { return area.size(); }
    TriangleGeometry operator[](std::size_t e) const {
        return {{gradient1_x[e], gradient1_y[e]}, {gradient2_x[e], gradient2_y[e]}, area[e]};
    }
    void push_back(const TriangleGeometry& g) {
        gradient1_x.push_back(g.gradient1.x);
        gradient1_y.push_back(g.gradient1.y);
        gradient2_x.push_back(g.gradient2.x);
        gradient2_y.push_back(g.gradient2.y);
        area.push_back(g.area);
    }
};
/// Bytes of its arrays.
std::size_t memory_of(const TriangleTable& table);

/// A further contact slot of a node at which more than two contact edges meet: its grain has an outline that meets itself there.
struct FurtherSlot {
    std::int32_t node, slot;
};

/// A group of grains with their elements and nodes, all contiguous; no node is shared between chunks.
struct GrainChunk {
    Range elements;
    Range nodes;
    Range further_slots;
};

/// Constant data of a run. Node order: by grain, within a grain as in the specimen.
struct Assemblage {
    PlaneElasticity elasticity;
    std::vector<Vector2> position;                           ///< [n] reference, m
    std::vector<double> mass;                                ///< [n] kg per metre of thickness
    std::vector<double> inverse_mass;                        ///< [n]
    std::vector<double> rock_mass;                           ///< [n] what gravity pulls: without mass that scaling adds
    std::vector<std::array<std::int32_t, 3>> element_nodes;  ///< [e]
    TriangleTable element_geometry;                          ///< [e]
    std::vector<ContactGeometry> contacts;                   ///< [c]
    std::vector<std::array<std::int32_t, 2>> slots;  ///< [n] the contact forces on a node: a slot of zero where there is none
    std::vector<FurtherSlot> further_slots;          ///< ascending by node
    std::vector<GrainChunk> grain_chunks;
    std::vector<Range> contact_chunks;
    std::vector<std::int32_t> node_of_specimen;  ///< [n] internal index of a node of the specimen
    GrainSurface surface;
    double contact_length = 0;                            ///< sum over contacts, m
    VectorTarget vector_target = widest_vector_target();  ///< that kernels run on

    /// Of contact forces: all chunks, and a slot that stays zero.
    [[nodiscard]] std::size_t n_slot_values() const { return contact_chunks.size() * slot_stride + 2UL * contacts_per_chunk; }
    [[nodiscard]] std::int32_t n_nodes() const { return static_cast<std::int32_t>(position.size()); }
    [[nodiscard]] std::int32_t n_contacts() const { return static_cast<std::int32_t>(contacts.size()); }
    [[nodiscard]] std::int32_t n_elements() const { return static_cast<std::int32_t>(element_nodes.size()); }
};
/// Bytes of its arrays.
std::size_t memory_of(const Assemblage& assemblage);

/// Builds the assemblage of a validated specimen. Masses are lumped: a third of each triangle to each of its nodes.
Assemblage make_assemblage(const Specimen& specimen, const Rock& rock, PlaneCondition plane);

/// Ranges of items sorted by node that fall into the node range of each chunk of grains.
template <class Item, class NodeOf>
std::vector<Range> ranges_by_chunk(const Assemblage& a, const std::vector<Item>& items, NodeOf&& node_of) {
    std::vector<Range> ranges;
    std::int32_t i = 0;
    for (const GrainChunk& chunk : a.grain_chunks) {
        Range range{i, i};
        while (range.end < static_cast<std::int32_t>(items.size()) && node_of(items[range.end]) < chunk.nodes.end) {
            ++range.end;
        }
        i = range.end;
        ranges.push_back(range);
    }
    return ranges;
}

/// Square of the share of its length below which the mean of two facing edges has no direction any more: the grains have turned
/// by more than 150° to each other.
inline constexpr double lost_frame = 0.04;

}  // namespace graincrack
