// The list of pairs between two steps: what is listed, released and watched.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Updates the list between two steps: finds contacts that have lost their cohesion, releases those that moved far, searches anew
/// where that or the travel of the nodes since the last search asks for it, and sets the step of the next update (`next_check`).
/// With mass scaling there are no node–edge contacts: it changes nothing but the list and returns true when one begins, or a
/// contact is to be released, and is to be called again with unscaled masses. Serial; what it does depends on the state only.
/// \param shortest steps to the next update at least
bool update_pair_list(const Assemblage& assemblage, const StepParameters& parameters, std::int64_t shortest, State& state);

}  // namespace graincrack
