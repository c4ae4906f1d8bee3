// Bytes that structures keep in their arrays.
//
// A structure with arrays has a function `memory_of` beside it, which takes it apart by a structured binding: a member that is
// added to the structure and not to the function does not compile.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

namespace graincrack {

/// Of a value without arrays: none.
template <class Value>
requires std::is_trivially_copyable_v<Value>
constexpr std::size_t memory_of(const Value& /*value*/) { return 0; }

/// Of the items of an array, with what they keep in arrays of their own.
template <class Item>
std::size_t memory_of(const std::vector<Item>& items) {
    std::size_t bytes = items.size() * sizeof(Item);
    if constexpr (!std::is_trivially_copyable_v<Item>) {
        for (const Item& item : items) bytes += memory_of(item);
    }
    return bytes;
}

/// Of several members of a structure.
template <class... Members>
std::size_t memory_of_all(const Members&... members) {
    return (memory_of(members) + ...);
}

}  // namespace graincrack
