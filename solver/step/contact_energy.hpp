// Energy that contacts store.
#pragma once

#include "solver/model/state.hpp"

namespace graincrack {

/// Stored in the contacts of a chunk, J.
double stored_in_chunk(const Assemblage& assemblage, const ContactLaws& laws, std::int32_t chunk, const State& state);

/// Stored in contacts and in node–edge contacts, J.
double stored_in_contacts(const Assemblage& assemblage, const ContactLaws& laws, const State& state);

}  // namespace graincrack
