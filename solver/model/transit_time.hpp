// The clock of a specimen: how long a wave takes from platen to platen.
#pragma once

#include <cmath>

#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// Time that a bar wave takes over the height of the specimen, h/√(E/ρ), s.
inline double bar_transit_time(const Specimen& specimen, const Rock& rock) {
    return specimen.height / std::sqrt(rock.young_modulus / rock.density);
}

}  // namespace graincrack
