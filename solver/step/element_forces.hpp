// The element stage of a step: the forces of elements at the present displacements, chunk by chunk.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Sets the slots of `state.element_force` of a chunk of elements, and books what the temperature has worked since it was last
/// there. \param warmth without a meaning where `state.thermal` is empty
void find_element_forces(const Assemblage& assemblage, const Warmth& warmth, std::int32_t chunk, State& state);

}  // namespace graincrack
