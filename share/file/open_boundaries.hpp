// How much of the grain boundaries of a specimen is open from the start.
#pragma once

#include <cstddef>
#include <string>

#include "share/file/specimen.hpp"

namespace graincrack {

/// Of the boundaries between crystals that are no flaw; contacts between two crystals are one boundary.
struct OpenBoundaries {
    std::size_t n_open = 0;
    std::size_t n = 0;
    double share = 0;  ///< of the length
};
OpenBoundaries count_open_boundaries(const Specimen& specimen);
/// "93 of 310, 0.301 of their length"; "" if none is open.
std::string open_boundaries_text(const Specimen& specimen);

}  // namespace graincrack
