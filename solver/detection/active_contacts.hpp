// Moves the active node–edge contacts in vector lanes, and keeps the index by which nodes find their forces.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Moves the active contacts of a chunk to the present displacements, computes their forces and adds their friction to the sums.
void move_active_contacts(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t chunk, State& state);

/// Makes all contacts of the list active, after an update or when a run continues from a saved state.
void load_active(const Assemblage& assemblage, const ContactLaws& laws, ContactPairList& list);

/// Restores the active contacts of a saved state in their order, in which forces and friction are summed.
/// \pre `active.pair` and `active.count` are those that were saved
void resume_active(const Assemblage& assemblage, const ContactLaws& laws, ContactPairList& list);

/// Builds the index by which nodes find the forces of active contacts. It is needed after each detection that has changed them.
void index_node_forces(const Assemblage& assemblage, ContactPairList& list);

/// Adds a pair of the list to the active contacts of its chunk.
void append_active(const Assemblage& assemblage, const ContactLaws& laws, std::int32_t chunk, std::int32_t index,
                   ContactPairList& list);

/// Energy stored in the node–edge contacts of each chunk of nodes, J.
std::vector<double> energy_of_active_contacts(const Assemblage& assemblage, const ContactLaws& laws, const ContactPairList& list);

/// Energy stored in the bonded contacts of a chunk, J.
double stored_in_chunk(const Assemblage& assemblage, const ContactLaws& laws, std::int32_t chunk, const State& state);

/// Energy stored in bonded and node–edge contacts, J.
double stored_in_contacts(const Assemblage& assemblage, const ContactLaws& laws, const State& state);

}  // namespace graincrack
