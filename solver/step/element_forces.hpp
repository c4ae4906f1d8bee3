// The element stage of a step: computes the forces of elements at the present displacements, chunk by chunk.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Sets the slots of `state.element_force` (N) of a chunk of elements, and adds the work of temperature changes since the last
/// call to the sums. \param warmth unused if `state.thermal` is empty
void find_element_forces(const Assemblage& assemblage, const Warmth& warmth, std::int32_t chunk, State& state);

}  // namespace graincrack
