// The active node–edge contacts, moved side by side, and the index by which nodes find their forces.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Moves the active contacts of a chunk to the present displacements: their forces, friction into the sums.
void move_active_contacts(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t chunk, State& state);

/// Makes the contacts of the list active ones, after an update or where a run continues from a saved state.
void load_active(const Assemblage& assemblage, const ContactLaws& laws, ContactPairList& list);

/// The same of a saved state, in which the active contacts have an order: forces and friction are summed in it. `active.pair` and
/// `active.count` must be as they were saved.
void resume_active(const Assemblage& assemblage, const ContactLaws& laws, ContactPairList& list);

/// Builds the index by which nodes find the forces of active contacts; needed after every detection that has changed them.
void index_node_forces(const Assemblage& assemblage, ContactPairList& list);

/// Adds a pair of the list to the active ones of its chunk.
void append_active(const Assemblage& assemblage, const ContactLaws& laws, std::int32_t chunk, std::int32_t index,
                   ContactPairList& list);

/// Stored in the node–edge contacts of each chunk of nodes, J.
std::vector<double> energy_of_active_contacts(const Assemblage& assemblage, const ContactLaws& laws, const ContactPairList& list);

/// Stored in the bonded contacts of a chunk, J.
double stored_in_chunk(const Assemblage& assemblage, const ContactLaws& laws, std::int32_t chunk, const State& state);

/// Stored in bonded and in node–edge contacts, J.
double stored_in_contacts(const Assemblage& assemblage, const ContactLaws& laws, const State& state);

}  // namespace graincrack
