// Brings the parts that ranks have of arrays of the whole specimen together on the first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/model/part.hpp"

namespace graincrack {

/// Makes `values` on the first rank those of the owners of their items. \param owner_of (item) its rank, ascending or not
template <class Value, class OwnerOf>
void gather_items(const Part& part, const OwnerOf& owner_of, std::vector<Value>& values) {
    if (part.is_alone()) return;
    std::vector<Value> own;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (owner_of(static_cast<std::int32_t>(i)) == part.ranks->rank()) own.push_back(values[i]);
    }
    const std::vector<std::vector<Value>> of_ranks = part.ranks->gather_first(own);
    if (!part.ranks->is_first()) return;
    std::vector<std::size_t> at(of_ranks.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto rank = static_cast<std::size_t>(owner_of(static_cast<std::int32_t>(i)));
        values[i] = of_ranks[rank][at[rank]++];
    }
}

/// The same of arrays with `per_chunk` values for each chunk of a kind; the last chunk may lack some. What lies behind it counts
/// as its own.
template <class Value>
void gather_chunks(const Part& part, const ChunkShare& chunks, std::size_t per_chunk, std::vector<Value>& values) {
    if (chunks.count == 0) return;
    gather_items(
        part,
        [&](std::int32_t i) { return chunks.owner_of(std::min(i / static_cast<std::int32_t>(per_chunk), chunks.count - 1)); },
        values);
}

}  // namespace graincrack
