// The node–edge contacts that go on, moved side by side, and where the nodes find their forces.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Moves the touches of a block to the present displacements: their forces, friction into the sums.
void move_active_contacts(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t block, State& state);

/// Writes what the moving touches of a block have become into the list.
void store_active(std::int32_t block, ContactPairList& list);

/// Makes the touches of the list that go on into moving ones, after a look or where a run goes on from a saved state.
void load_active(const Assemblage& assemblage, ContactPairList& list);

/// Finds by node where the forces of the moving touches are; to be called where a review has changed them.
void index_node_forces(const Assemblage& assemblage, ContactPairList& list);

/// Adds a pair of the list to the moving ones of its block.
void append_active(const GrainSurface& surface, std::int32_t block, std::int32_t index, ContactPairList& list);

/// Stored in all touches, J.
double stored_in_active_contacts(const ContactLaw& law, const ContactPairList& list);

}  // namespace graincrack
