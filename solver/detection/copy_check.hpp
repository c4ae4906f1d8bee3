// Whether what several ranks evaluate is the same on each: a fault in what they tell each other shows where it begins.
#pragma once

#include "solver/model/state.hpp"

namespace graincrack {

/// Compares what ranks have of contacts and node–edge contacts on cuts. To be called by all ranks.
/// \throws NumericalError naming the step, the first chunk that differs, and the ranks
void require_equal_copies(const Assemblage& assemblage, const State& state);

}  // namespace graincrack
