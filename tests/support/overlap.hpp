// Overlap of grains: the depth of nodes in other grains, found from the triangles without the solver's search.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "solver/model/assemblage.hpp"

namespace graincrack::test {

/// Largest depth of any node in any triangle of another grain, m; 0 if none is inside another.
inline double deepest_overlap(const Assemblage& a, const std::vector<Vector2>& displacement) {
    const auto place = [&](std::int32_t n) { return a.position[n] + displacement[n]; };
    double deepest = 0;
    for (const auto& element : a.element_nodes) {
        const Vector2 corner[3] = {place(element[0]), place(element[1]), place(element[2])};
        for (std::int32_t n = 0; n < a.n_nodes(); ++n) {
            if (a.surface.grain_of_node[n] == a.surface.grain_of_node[element[0]]) continue;
            double depth = std::numeric_limits<double>::max();
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector2 along = corner[(k + 1) % 3] - corner[k];
                const Vector2 from = place(n) - corner[k];
                depth = std::min(depth, (along.x * from.y - along.y * from.x) / length(along));
            }
            deepest = std::max(deepest, depth);
        }
    }
    return deepest;
}

}  // namespace graincrack::test
