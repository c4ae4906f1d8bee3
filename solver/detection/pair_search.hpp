// The general search: which exposed nodes and edges are near each other.
#pragma once

#include <vector>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// All pairs of an exposed node and an exposed edge of another grain it is not linked to, nearer than `margin` (m); ascending.
std::vector<CandidatePair> find_pairs(const Assemblage& assemblage, double margin, const State& state);

}  // namespace graincrack
