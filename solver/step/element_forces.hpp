// The element stage of a step: the forces of elements at the present displacements, chunk by chunk.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Sets the slots of `state.element_force` of a chunk of elements.
void find_element_forces(const Assemblage& assemblage, std::int32_t chunk, State& state);

}  // namespace graincrack
