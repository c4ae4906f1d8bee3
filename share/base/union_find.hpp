// Disjoint sets with path halving, which find connected elements. A call costs O(log n) amortised.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace graincrack {

class UnionFind {
public:
    explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

    /// The representative of the set of i: its smallest member.
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        i = find(i);
        j = find(j);
        if (i < j) parent_[j] = i;
        if (j < i) parent_[i] = j;
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace graincrack
