// The update of the pair list between two steps: which contacts are released, which pairs are listed and watched.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Most steps from one update to the next.
inline constexpr std::int64_t max_update_interval = 128;

/// Updates the list between two steps: finds points that have debonded, releases contacts that have moved far, searches anew
/// where that or the travel of the nodes since the last search makes it necessary, limits areas to what the step allows, chooses
/// the watched pairs, and sets the step of the next update (`next_update`). One thread of each rank does it, all ranks together;
/// the result depends on the state only.
void update_pair_list(const Assemblage& assemblage, const StepParameters& parameters, State& state);

}  // namespace graincrack
