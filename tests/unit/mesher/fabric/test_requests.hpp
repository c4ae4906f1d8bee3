// Specimens that the tests of their fabric begin with.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "mesher/mesh.hpp"

namespace graincrack::mesher {

inline Request rectangle_of(std::int64_t grains) {
    Request request;
    request.region = rectangle(0.08, 0.16);
    request.fabric.grains = grains;
    return request;
}

/// Every grain its own crystal.
inline std::vector<int> own_crystals(const Specimen& specimen) {
    std::vector<int> crystals(specimen.n_grains());
    std::iota(crystals.begin(), crystals.end(), 0);
    return crystals;
}

}  // namespace graincrack::mesher
