// Requests that tests begin with, what they are refused for, and measures of the specimens that come out.
#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "mesher/mesh.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

inline Request rectangle_of(std::int64_t grains, std::uint64_t seed = 1) {
    Request request;
    request.region = rectangle(0.08, 0.16);
    request.fabric.grains = grains;
    request.seed = seed;
    return request;
}

/// Every grain its own crystal.
inline std::vector<int> own_crystals(const Specimen& specimen) {
    std::vector<int> crystals(specimen.n_grains());
    std::iota(crystals.begin(), crystals.end(), 0);
    return crystals;
}

/// The message of the UsageError that a request causes once it is changed; "" if there is none.
template <class Change>
std::string refusal(Request request, const Change& change) {
    change(request);
    try {
        plan_mesh(request);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}
inline std::string refusal(const Request& request) {
    return refusal(request, [](Request&) {});
}

inline Point place_of(const Specimen& specimen, std::int32_t node) {
    const auto& [x, y] = specimen.node_position[index(node)];
    return {x, y};
}

/// Length of the contacts that are broken from the start, m.
inline double broken_length(const Specimen& specimen) {
    double sum = 0;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (starts_broken(specimen.contact_kind[c])) sum += contact_length(specimen, c);
    }
    return sum;
}

}  // namespace graincrack::mesher
