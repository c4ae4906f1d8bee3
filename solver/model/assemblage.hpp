// The assemblage as the kernels see it: constant data in structures of arrays, with grains in the order of the specimen, cut into
// chunks. A chunk is what a thread works on at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "share/file/fabric.hpp"
#include "share/file/specimen.hpp"
#include "share/rock/fracture_process_zone.hpp"
#include "solver/arithmetic/simd.hpp"
#include "solver/arithmetic/vector2.hpp"
#include "solver/model/element.hpp"
#include "solver/model/node_order.hpp"
#include "solver/model/part.hpp"
#include "solver/model/range.hpp"
#include "solver/model/surface.hpp"

namespace graincrack {

/// Most contacts in a chunk.
inline constexpr std::int32_t contacts_per_chunk = 64;

/// A contact's constant geometry.
struct ContactGeometry {
    std::array<std::int32_t, 4> nodes;  ///< a1 a2 b1 b2
    Vector2 edge;                       ///< a1 → a2 in the reference, m
    double point_area;                  ///< of one of its two points: half the edge × 1 m, m²
    double strength = 1;                ///< s: factor on the strengths of its class (solver/law/contact_law.hpp)
};

/// Contacts of one class that a thread works on at a time. Chunk k has the places from k · `contacts_per_chunk` on; the places
/// behind its last contact are empty.
struct ContactChunk {
    Range contacts;
    std::int32_t contact_class;
};

/// Most elements in a chunk.
inline constexpr std::int32_t elements_per_chunk = 64;

/// Each contact and each element has slots for the forces on its nodes. They lie by chunk, [chunk][node of the item][x y][place
/// in the chunk], so that kernels write them side by side. A slot is named by where its x is in `State::contact_force` or
/// `State::element_force`; its y is a chunk's places farther.
inline constexpr std::int32_t slot_stride = 8 * contacts_per_chunk;  ///< of a chunk of contacts: a1 a2 b1 b2
inline std::int32_t slot_of(std::int32_t contact, std::int32_t node) {
    return contact / contacts_per_chunk * slot_stride + 2 * node * contacts_per_chunk + contact % contacts_per_chunk;
}
inline constexpr std::int32_t element_slot_stride = 6 * elements_per_chunk;
inline std::int32_t element_slot_of(std::int32_t element, std::int32_t node) {
    return element / elements_per_chunk * element_slot_stride + 2 * node * elements_per_chunk + element % elements_per_chunk;
}

/// A slot beyond those that every node has.
struct FurtherSlot {
    std::int32_t node, slot;
};

/// The slots of each node: `few` that every node has, and further ones of some.
template <std::size_t few>
struct SlotsOfNodes {
    std::vector<std::array<std::int32_t, few>> first;  ///< [n] a slot of zero where there is none
    std::vector<FurtherSlot> further;                  ///< ascending by node
    std::vector<Range> further_of_chunk;               ///< by chunk of nodes
};

/// Elasticity of all triangles, side by side.
struct ElasticityTable {
    std::vector<double> c11, c12, mu, czz;  ///< as in `PlaneElasticity`
    PlaneElasticity operator[](std::size_t e) const { return {c11[e], c12[e], mu[e], czz[e]}; }
    void push_back(const PlaneElasticity& c) {
        c11.push_back(c.c11);
        c12.push_back(c.c12);
        mu.push_back(c.mu);
        czz.push_back(c.czz);
    }
};

/// How the elements of an assemblage expand and soften.
struct Expansion {
    std::vector<Phase> phases;  ///< none if temperature does nothing to them, then elements have nothing here
    PlaneCondition plane = PlaneCondition::strain;
    std::vector<std::uint8_t> phase;  ///< [e]
    std::vector<CrystalAxis> axis;    ///< [e]
    [[nodiscard]] bool empty() const { return phases.empty(); }
    /// What a temperature (K) does to an element.
    [[nodiscard]] PlaneWarmth of_element(std::size_t e, double temperature) const {
        return plane_warmth(phases[phase[e]], plane, temperature);
    }
};

/// What a temperature does to the phases: found once for all elements.
struct Warmth {
    double temperature = 0;             ///< K
    std::vector<PlaneWarmth> of_phase;  ///< none before a temperature was given
    void go_to(double new_temperature, const Expansion& expansion) {
        if (new_temperature == temperature && !of_phase.empty()) return;
        temperature = new_temperature;
        of_phase.clear();
        for (const Phase& p : expansion.phases) of_phase.push_back(plane_warmth(p, expansion.plane, temperature));
    }
};

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

/// Constant data of a run. Order of elements: as in the specimen. Order of nodes: see solver/model/node_order.hpp. Order of
/// contacts: by class, within a class as in the specimen, with empty places at the ends of chunks.
struct Assemblage {
    std::vector<Vector2> position;                           ///< [n] reference, m
    std::vector<double> mass;                                ///< [n] kg per metre of thickness
    std::vector<double> inverse_mass;                        ///< [n]
    std::vector<double> rock_mass;                           ///< [n] what gravity pulls: without mass that scaling adds
    std::vector<std::array<std::int32_t, 3>> element_nodes;  ///< [e]
    TriangleTable element_geometry;                          ///< [e]
    ElasticityTable elasticity;                              ///< [e]
    Expansion expansion;
    std::vector<double> element_mass;       ///< [e] of rock, kg per metre of thickness
    std::vector<ContactGeometry> contacts;  ///< [c] by place; empty places have no area
    SlotsOfNodes<2> contact_slots;          ///< further ones where the outline of a grain meets itself
    SlotsOfNodes<1> element_slots;          ///< further ones where elements of a grain meet
    std::vector<NodeChunk> node_chunks;
    std::vector<Range> rows;                    ///< of nodes, in chunks of nodes
    std::vector<std::int32_t> cluster_of_node;  ///< [n] its vertex cluster
    std::vector<Range> element_chunks;
    std::vector<ContactChunk> contact_chunks;
    std::vector<std::int32_t> node_of_specimen;     ///< [n] internal index of a node of the specimen
    std::vector<std::int32_t> contact_of_specimen;  ///< place of a contact of the specimen
    std::vector<std::int32_t> specimen_contact;     ///< [c] contact of the specimen at a place, −1 if it is empty
    std::vector<std::uint8_t> phase_of_node;        ///< [n]
    std::int32_t n_phase_classes = 0;               ///< classes of contacts by phases; those of flaws follow
    GrainSurface surface;
    double contact_length = 0;                            ///< sum over contacts, m
    VectorTarget vector_target = widest_vector_target();  ///< that kernels run on
    Part part;                                            ///< that this rank works on

    /// The slots of contact forces, and those of element forces: of all chunks, and one that stays zero.
    [[nodiscard]] std::size_t n_slot_values() const { return contact_chunks.size() * slot_stride + 2UL * contacts_per_chunk; }
    [[nodiscard]] std::size_t n_element_slot_values() const {
        return element_chunks.size() * element_slot_stride + 2UL * elements_per_chunk;
    }
    [[nodiscard]] std::int32_t n_nodes() const { return static_cast<std::int32_t>(position.size()); }
    [[nodiscard]] std::int32_t n_clusters() const { return node_chunks.empty() ? 0 : node_chunks.back().clusters.end; }
    /// Without empty places.
    [[nodiscard]] std::int32_t n_contacts() const { return static_cast<std::int32_t>(contact_of_specimen.size()); }
    [[nodiscard]] std::int32_t n_elements() const { return static_cast<std::int32_t>(element_nodes.size()); }
};

/// Builds the assemblage of a validated specimen. Masses are lumped: a third of each triangle to each of its nodes.
/// \param phases by index of the specimen's phases
Assemblage make_assemblage(const Specimen& specimen, const std::vector<Phase>& phases, PlaneCondition plane);
/// The largest difference of the free expansions of phases and axes of crystals, at least a third of the largest of them, 1/K: by
/// what a change of temperature strains a specimen. 0 where nothing expands.
double expansion_difference(const Assemblage& assemblage);
/// All grains are of the rock.
Assemblage make_assemblage(const Specimen& specimen, const Rock& rock, PlaneCondition plane);

/// Calls `act` with the place and the class of each contact.
template <class Act>
void for_each_contact(const Assemblage& a, const Act& act) {
    for (const ContactChunk& chunk : a.contact_chunks) {
        for (std::int32_t c = chunk.contacts.begin; c < chunk.contacts.end; ++c) act(c, chunk.contact_class);
    }
}
/// Calls `act` with the place and the class of each contact of this rank's own.
template <class Act>
void for_each_own_contact(const Assemblage& a, const Act& act) {
    for (const std::int32_t index : a.part.contacts.own) {
        const ContactChunk& chunk = a.contact_chunks[index];
        for (std::int32_t c = chunk.contacts.begin; c < chunk.contacts.end; ++c) act(c, chunk.contact_class);
    }
}

/// Σ `of_item(i)` over the items of a range.
template <class OfItem>
auto sum_over(Range range, const OfItem& of_item) {
    decltype(of_item(0)) sum{};
    for (std::int32_t i = range.begin; i < range.end; ++i) sum += of_item(i);
    return sum;
}
/// Σ `of_item(i)` over ranges of items, one a chunk of nodes.
template <class OfItem>
auto sum_by_nodes(const Assemblage& a, const std::vector<Range>& ranges, const OfItem& of_item) {
    return sum_over_chunks(a.part, a.part.nodes, [&](std::int32_t chunk) { return sum_over(ranges[chunk], of_item); });
}
/// Σ `of_node(i)` over all nodes, by chunk.
template <class OfNode>
auto sum_over_nodes(const Assemblage& a, const OfNode& of_node) {
    return sum_over_chunks(a.part, a.part.nodes,
                           [&](std::int32_t chunk) { return sum_over(a.node_chunks[chunk].nodes, of_node); });
}
/// The chunk of a node.
inline std::int32_t chunk_of_node(const Assemblage& a, std::int32_t node) {
    const auto after = std::upper_bound(a.node_chunks.begin(), a.node_chunks.end(), node,
                                        [](std::int32_t i, const NodeChunk& chunk) { return i < chunk.nodes.begin; });
    return static_cast<std::int32_t>(after - a.node_chunks.begin()) - 1;
}
/// Calls `act` with each node of a vertex cluster of a chunk.
template <class Act>
void for_each_node_of(const Assemblage& a, const NodeChunk& chunk, std::int32_t cluster, const Act& act) {
    const std::int32_t column = cluster - chunk.clusters.begin;
    for (std::int32_t row = chunk.rows.begin; row < chunk.rows.end && column < a.rows[row].size(); ++row) {
        act(a.rows[row].begin + column);
    }
}
/// Class of the contact whose side an edge of the surface is; −1 on a free face.
inline std::int32_t class_of_edge(const Assemblage& a, std::int32_t edge) {
    const std::int32_t contact = a.surface.edges[edge].contact;
    return contact < 0 ? -1 : a.contact_chunks[contact / contacts_per_chunk].contact_class;
}
/// Class of a node–edge contact: that of a flaw if both lie on it, else that of the phases of the two grains.
inline std::int32_t class_between(const Assemblage& a, std::int32_t node, std::int32_t edge) {
    if (const std::int32_t flaw = class_of_edge(a, edge); flaw >= a.n_phase_classes) {
        for (std::int32_t k = a.surface.edge_begin[node]; k < a.surface.edge_begin[node + 1]; ++k) {
            if (class_of_edge(a, a.surface.edges_of_node[k]) == flaw) return flaw;
        }
    }
    return static_cast<std::int32_t>(contact_class(a.phase_of_node[node], a.phase_of_node[a.surface.edges[edge].nodes[0]]));
}

/// Ranges of items sorted by node that fall into each chunk of nodes.
template <class Item, class NodeOf>
std::vector<Range> ranges_by_chunk(const Assemblage& a, const std::vector<Item>& items, NodeOf&& node_of) {
    std::vector<Range> ranges;
    std::int32_t i = 0;
    for (const NodeChunk& chunk : a.node_chunks) {
        Range range{i, i};
        while (range.end < static_cast<std::int32_t>(items.size()) && node_of(items[range.end]) < chunk.nodes.end) ++range.end;
        i = range.end;
        ranges.push_back(range);
    }
    return ranges;
}

/// Square of the fraction of its length below which the mean of two facing edges has no direction any more: the grains have
/// turned by more than 157° to each other. The contact is broken then; what cohesion it had left counts as dissipated, without
/// work.
inline constexpr double lost_frame = 0.04;

}  // namespace graincrack
