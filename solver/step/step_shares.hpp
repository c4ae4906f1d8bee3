// Divides a step among the threads of a team into shares of equal cost: numbers of items times the cost of each. Sums are made by
// chunk, whichever thread works on it, so that shares do not affect results.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// The chunks that a thread works on.
struct StepShare {
    using Chunks = std::span<const std::int32_t>;
    Chunks nodes, loaded, inner_elements, outer_elements, inner_contacts, outer_contacts;
    Range pairs;
};

/// Cost of each stage for the busiest thread, over the mean of all threads.
struct StepBalance {
    int threads = 1;
    double nodes = 1;   ///< nodal forces and integration
    double forces = 1;  ///< contacts, elements, loads; with several ranks those with ghosts
};

struct StepShares {
    std::vector<StepShare> of_threads;
    StepBalance balance;
};
/// Divides a step; linear in the number of items. \param s state with failed contacts and pair list; null: nothing has failed
StepShares share_step(const Assemblage& assemblage, const Boundary& boundary, const State* s, int n_threads);

}  // namespace graincrack
