// Exchanges the contact pair list between ranks. A rank has all pairs of its own nodes and of nodes near an edge of its own
// nodes. It moves every contact that acts on one of its nodes; other ranks on whose nodes the contact acts move it too, with the
// same numbers. When a search gives a pair to another rank, the owner of its node sends the state of the contact.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/model/state.hpp"

namespace graincrack {

/// Exposed edges of the surface (see solver/model/contact_pairs.hpp), ascending.
std::vector<std::int32_t> find_exposed_edges(const Assemblage& assemblage, const ContactPairList& list);

/// Fetches the displacements of nodes of other ranks at exposed edges that may lie within `margin` (m) of own ones.
/// \return [n] 1 for nodes whose displacement is known; 1 throughout for a single rank
std::vector<std::uint8_t> exchange_exposed_nodes(const Assemblage& assemblage, const std::vector<std::int32_t>& exposed_edges,
                                                 double margin, State& state);

/// Removes the pairs of nodes of which no pair acts on an own node. \param pairs ascending
void keep_pairs_of_own_nodes(const Assemblage& assemblage, std::vector<CandidatePair>& pairs);

/// Requests the nodes that this rank reads from their owners: those of its part, of its pairs and of the edges next to these.
void find_ghosts(const Assemblage& assemblage, State& state);

/// Takes the contacts of other ranks' nodes from their owners. \throws NumericalError if the pairs of both differ
void take_contacts_of_owners(const Assemblage& assemblage, ContactPairList& list);

}  // namespace graincrack
