// Brings the parts that ranks have of arrays of the whole specimen together on the first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
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

/// The same of arrays with `per_chunk` values for each chunk of a kind; the last chunk may lack some.
template <class Value>
void gather_chunks(const Part& part, const ChunkShare& chunks, std::size_t per_chunk, std::vector<Value>& values) {
    if (part.is_alone()) return;
    const auto range_of = [&](std::int32_t chunk) {
        const std::size_t begin = per_chunk * static_cast<std::size_t>(chunk);
        return std::pair(std::min(begin, values.size()), std::min(begin + per_chunk, values.size()));
    };
    std::vector<Value> own;
    for (const std::int32_t chunk : chunks.own) {
        const auto [begin, end] = range_of(chunk);
        own.insert(own.end(), values.begin() + static_cast<std::ptrdiff_t>(begin),
                   values.begin() + static_cast<std::ptrdiff_t>(end));
    }
    const std::vector<std::vector<Value>> of_ranks = part.ranks->gather_first(own);
    if (!part.ranks->is_first()) return;
    std::vector<std::size_t> at(of_ranks.size(), 0);
    for (std::int32_t chunk = 0; chunk < chunks.count; ++chunk) {
        const auto rank = static_cast<std::size_t>(chunks.owner_of(chunk));
        const auto [begin, end] = range_of(chunk);
        for (std::size_t i = begin; i < end; ++i) values[i] = of_ranks[rank][at[rank]++];
    }
}

/// The same of arrays with a value for each node.
template <class Value>
void gather_nodes(const Part& part, std::vector<Value>& values) {
    if (part.is_alone() || values.empty()) return;
    const Range nodes = part.own_nodes();
    const std::vector<Value> own(values.begin() + nodes.begin, values.begin() + nodes.end);
    std::size_t at = 0;
    for (const std::vector<Value>& of_rank : part.ranks->gather_first(own)) {
        for (const Value& value : of_rank) values[at++] = value;
    }
}

}  // namespace graincrack
