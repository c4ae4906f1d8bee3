// The contact stage of a step: the law of its class at every contact that has not been released, chunk by chunk.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Advances the contacts of a chunk to the present displacements: histories, slots, energies, events.
void advance_contacts(const Assemblage& assemblage, const ContactLaws& laws, std::int32_t chunk, std::int64_t step, State& state);

}  // namespace graincrack
