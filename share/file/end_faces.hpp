// How platens meet a specimen: told from the parts of its boundary, whatever its shape is called.
#pragma once

#include <algorithm>

#include "share/file/specimen.hpp"

namespace graincrack {

/// Extent along x of a part of the boundary, m; 0 if there is none.
inline double width_of_part(const Specimen& specimen, BoundaryPart part) {
    double left = specimen.width;
    double right = -specimen.width;
    for (std::size_t e = 0; e < specimen.n_boundary_edges(); ++e) {
        if (specimen.boundary_part[e] != static_cast<std::uint8_t>(part)) continue;
        for (const std::int32_t node : specimen.boundary_edges[e]) {
            left = std::min(left, specimen.node_position[static_cast<std::size_t>(node)][0]);
            right = std::max(right, specimen.node_position[static_cast<std::size_t>(node)][0]);
        }
    }
    return std::max(0.0, right - left);
}

/// Whether platens meet a specimen with faces, the boundary parts bottom and top, that are at least half as wide as it. A disc
/// has none, or flat poles that are narrower: it is loaded along its diameter.
inline bool has_end_faces(const Specimen& specimen) {
    const double half = specimen.width / 2;
    return width_of_part(specimen, BoundaryPart::bottom) >= half && width_of_part(specimen, BoundaryPart::top) >= half;
}

/// Width between the platens in which load and strain are those of the test, m: that of the end faces; without them half the
/// width of the specimen.
inline double loaded_width(const Specimen& specimen) { return specimen.width * (has_end_faces(specimen) ? 1.0 : 0.5); }

}  // namespace graincrack
