// The node–edge contacts that go on, moved side by side, and where the nodes find their forces.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Moves the touches of a block to the present displacements: their forces, friction into the sums.
void move_touches(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t block, State& state);

/// Writes what the moving touches of a block have become into the list.
void settle_touches(std::int32_t block, TouchList& list);

/// Makes the touches of the list that go on into moving ones, after a look or where a run goes on from a saved state.
void take_up_touches(const Assemblage& assemblage, TouchList& list);

/// Finds by node where the forces of the moving touches are; to be called where a review has changed them.
void arrange_gathers(const Assemblage& assemblage, TouchList& list);

/// Adds a pair of the list to the moving ones of its block.
void append_moving(const Outline& outline, std::int32_t block, std::int32_t index, TouchList& list);

/// Stored in all touches, J.
double stored_in_touches(const ContactLaw& law, const TouchList& list);

}  // namespace graincrack
