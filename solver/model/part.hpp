// The part of a specimen that a rank works on: it owns chunks of nodes that follow each other, and evaluates all elements and
// contacts with a node of them. What lies on a cut is so evaluated by every rank with a node of it, with the same numbers in the
// same order, and no force is sent. The other nodes of what a rank evaluates are its ghosts: their owner sends their motion.
//
// All ranks keep the indices of the whole specimen. Entries of what they neither own nor evaluate are never right, and not read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/arithmetic/sums.hpp"
#include "solver/model/range.hpp"
#include "solver/ranks/ranks.hpp"

namespace graincrack {

struct Assemblage;
struct PrescribedConditions;

/// Who owns which chunks of one kind: whole sums, of some chunks that follow each other.
struct ChunkShare {
    std::int32_t count = 0;               ///< of all chunks
    std::int32_t chunks_per_sum = 1;      ///< the last sum may have fewer
    std::vector<std::int32_t> own_sums;   ///< of this rank, ascending
    std::vector<std::int32_t> own;        ///< their chunks
    std::vector<std::int32_t> owner;      ///< [sums] the rank
    std::vector<std::int32_t> n_sums_of;  ///< [ranks]
    [[nodiscard]] std::int32_t n_sums() const { return (count + chunks_per_sum - 1) / chunks_per_sum; }
    [[nodiscard]] Range chunks_of_sum(std::int32_t sum) const {
        return {sum * chunks_per_sum, std::min((sum + 1) * chunks_per_sum, count)};
    }
    [[nodiscard]] int owner_of(std::int32_t chunk) const { return owner[chunk / chunks_per_sum]; }
};

/// Chunks that a rank evaluates: those without ghosts, which need no message, and the others. Threads work on consecutive ones.
/// Those of contacts are in the order of their nodes, so that a thread reads few motions that others wrote, and few others read
/// its forces.
struct EvaluatedChunks {
    std::vector<std::int32_t> inner, outer;
};

struct Part {
    const Ranks* ranks = &Ranks::alone();
    ChunkShare nodes, elements, contacts;
    std::vector<std::int32_t> first_node;  ///< [ranks + 1] of each rank's own nodes
    EvaluatedChunks evaluated_elements, evaluated_contacts;
    std::vector<std::uint8_t> evaluates_contacts;  ///< [chunks of contacts] 1 for those
    std::vector<std::int32_t> loaded_chunks;       ///< of nodes, whose loaded edges it evaluates
    std::vector<std::int32_t> ghosts;              ///< nodes, ascending; those of node–edge contacts come and go besides
    [[nodiscard]] bool is_alone() const { return ranks->is_alone(); }
    [[nodiscard]] Range own_nodes() const { return {first_node[ranks->rank()], first_node[ranks->rank() + 1]}; }
    [[nodiscard]] bool owns(std::int32_t node) const {
        const Range own = own_nodes();
        return node >= own.begin && node < own.end;
    }
    [[nodiscard]] int owner_of_node(std::int32_t node) const {
        return static_cast<int>(std::upper_bound(first_node.begin(), first_node.end(), node) - first_node.begin()) - 1;
    }
};

/// The part of a rank alone: all.
Part whole_part(const Assemblage& assemblage);
/// The part of this rank, with an equal share of the work.
Part make_part(const Assemblage& assemblage, const PrescribedConditions& prescribed, const Ranks& ranks);

/// Σ `of_chunk(chunk)` over all chunks of a kind: first over those of each sum, then over the sums, in their order. All sums of a
/// run are made so; they do not depend on who owns what.
template <class OfChunk>
auto sum_over_chunks(const Part& part, const ChunkShare& chunks, const OfChunk& of_chunk) {
    using Value = decltype(of_chunk(0));
    std::vector<Value> sums;
    sums.reserve(chunks.own_sums.size());
    for (const std::int32_t sum : chunks.own_sums) {
        const Range range = chunks.chunks_of_sum(sum);
        Value& of_range = sums.emplace_back();
        for (std::int32_t chunk = range.begin; chunk < range.end; ++chunk) of_range += of_chunk(chunk);
    }
    const std::vector<std::vector<Value>> of_ranks = part.ranks->gather_all(sums, chunks.n_sums_of);
    std::vector<std::size_t> at(of_ranks.size(), 0);
    Value total{};
    for (const std::int32_t rank : chunks.owner) total += of_ranks[rank][at[rank]++];
    return total;
}

/// Calls `act` with each chunk that a rank evaluates.
template <class Act>
void for_each_evaluated(const EvaluatedChunks& chunks, const Act& act) {
    for (const std::int32_t chunk : chunks.inner) act(chunk);
    for (const std::int32_t chunk : chunks.outer) act(chunk);
}

/// Values of some nodes, of whatever rank, in the order of the nodes.
template <class Value>
std::vector<Value> values_at(const Part& part, const std::vector<std::int32_t>& nodes, const std::vector<Value>& values) {
    std::vector<Value> own;
    std::vector<std::int32_t> counts(static_cast<std::size_t>(part.ranks->size()), 0);
    for (const std::int32_t node : nodes) {
        ++counts[part.owner_of_node(node)];
        if (part.owns(node)) own.push_back(values[node]);
    }
    const std::vector<std::vector<Value>> of_ranks = part.ranks->gather_all(own, counts);
    std::vector<std::size_t> at(of_ranks.size(), 0);
    std::vector<Value> found;
    for (const std::int32_t node : nodes) {
        const int rank = part.owner_of_node(node);
        found.push_back(of_ranks[rank][at[rank]++]);
    }
    return found;
}

}  // namespace graincrack
