// The contact pair list over several ranks. Each has all pairs of the nodes that it owns and of those that are near an edge of
// its own nodes: it moves every contact that acts on an own node, as do the others that it acts on, with the same numbers. The
// owner of the node of a pair says what state the contact is in when a search gives the pair to another rank.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/model/state.hpp"

namespace graincrack {

/// Exposed edges of the surface (see solver/model/contact_pairs.hpp), ascending.
std::vector<std::int32_t> find_exposed_edges(const Assemblage& assemblage, const ContactPairList& list);

/// Brings the displacements of nodes of other ranks at exposed edges that may be within `margin` (m) of own ones.
/// \return [n] 1 for nodes whose displacement is known; all for a rank alone
std::vector<std::uint8_t> exchange_exposed_nodes(const Assemblage& assemblage, const std::vector<std::int32_t>& exposed_edges,
                                                 double margin, State& state);

/// Removes the pairs of nodes that have no pair which acts on an own node. \param pairs ascending
void keep_pairs_of_own_nodes(const Assemblage& assemblage, std::vector<CandidatePair>& pairs);

/// Asks the owners for the nodes that this rank reads: those of its part, and of its pairs and the edges beside them.
void find_ghosts(const Assemblage& assemblage, State& state);

/// Makes the contacts of pairs of other ranks' nodes those that their owners have. \throws NumericalError if a rank has other
/// pairs of a node than its owner
void take_contacts_of_owners(const Assemblage& assemblage, ContactPairList& list);

}  // namespace graincrack
