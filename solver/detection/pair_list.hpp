// The list of pairs between two steps: what is listed, released and watched.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Looks after the list between two steps: finds contacts that lost their cohesion, releases those that moved far, searches
/// anew where that or the way the nodes have gone since the last search asks for it, and says when to look again
/// (`next_check`). With mass scaling there are no touches: it changes nothing but the list and returns true when one begins, or a
/// contact is to be released, and is to be called again with masses as they are. Serial; what it does depends on the state only.
/// \param shortest steps there are to the next look at least
bool update_pair_list(const Assemblage& assemblage, const StepParameters& parameters, std::int64_t shortest, State& state);

}  // namespace graincrack
