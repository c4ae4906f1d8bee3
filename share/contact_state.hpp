// State of a contact point and mode of a micro-crack, as the solver's laws and the files number them.
#pragma once

#include <cstdint>

namespace graincrack {

/// State of a contact point (dataset /frames/NNNN/state).
enum class PointState : std::uint8_t { intact = 0, failed_tension = 1, failed_shear = 2, separated = 3 };
/// Mode of a micro-crack (dataset /cracks/mode).
enum class CrackMode : std::uint8_t { tensile = 0, shear = 1 };

}  // namespace graincrack
