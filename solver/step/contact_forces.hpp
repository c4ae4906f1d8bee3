// The contact stage of a step: applies the law of its class to every contact that is not released, chunk by chunk.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Advances the contacts of a chunk to the present displacements: histories, force slots (N), energies (J) and events.
void advance_contacts(const Assemblage& assemblage, const ContactLaws& laws, std::int32_t chunk, std::int64_t step, State& state);

}  // namespace graincrack
