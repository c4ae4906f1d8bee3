// How platens meet a specimen: told from the parts of its boundary, whatever its shape is called.
#pragma once

#include <algorithm>

#include "share/file/specimen.hpp"

namespace graincrack {

/// Whether platens meet a specimen with faces, the boundary parts bottom and top. A disc has none: it is loaded along its
/// diameter.
inline bool has_end_faces(const Specimen& specimen) {
    const auto has = [&](BoundaryPart part) {
        return std::find(specimen.boundary_part.begin(), specimen.boundary_part.end(), static_cast<std::uint8_t>(part)) !=
               specimen.boundary_part.end();
    };
    return has(BoundaryPart::bottom) && has(BoundaryPart::top);
}

/// Width between the platens in which load and strain are those of the test, m: that of the end faces; without them half the
/// width of the specimen.
inline double loaded_width(const Specimen& specimen) { return specimen.width * (has_end_faces(specimen) ? 1.0 : 0.5); }

}  // namespace graincrack
