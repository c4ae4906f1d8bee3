// Updates the contact pair list between two steps: releases contacts, lists pairs, and chooses the pairs that steps watch.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Most steps from one update to the next. Chosen by trial.
inline constexpr std::int64_t max_update_interval = 128;

/// Updates the list between two steps. It finds points that have debonded, releases contacts that have moved far, searches anew
/// if these or the travel of the nodes since the last search require it, limits the areas of contacts to what the time step
/// allows, chooses the watched pairs, and sets the step of the next update (`next_update`). All ranks call it together, each in
/// one thread; the result depends on the state only. The cost is linear in contacts, nodes and pairs; a search is O(n log n).
void update_pair_list(const Assemblage& assemblage, const StepParameters& parameters, State& state);

}  // namespace graincrack
