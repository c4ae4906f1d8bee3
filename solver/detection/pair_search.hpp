// The general search: which exposed nodes and edges are near each other.
#pragma once

#include <vector>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// All pairs of an exposed node and an exposed edge of another grain it is not linked to, nearer than `margin` (m); ascending. Of
/// nodes without a pair that acts on a node of this rank, none. Brings the displacements of other ranks' nodes that it needs.
std::vector<CandidatePair> find_pairs(const Assemblage& assemblage, double margin, State& state);

}  // namespace graincrack
