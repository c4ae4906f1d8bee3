// Searches for exposed nodes and edges that are near each other.
#pragma once

#include <vector>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Returns, ascending, all pairs of an exposed node and an exposed edge of another grain that are nearer than `margin` (m) and
/// not linked: no contact points that have not debonded link the node to the edge, or the contact of both is released. Nodes
/// without a pair that acts on a node of this rank have none. Fetches the displacements of other ranks' nodes. The cost is O(n
/// log n) in the numbers of exposed edges and pairs, plus one pass over all contacts and nodes.
std::vector<CandidatePair> find_pairs(const Assemblage& assemblage, double margin, State& state);

}  // namespace graincrack
