// Shares of a team's threads in a step, of equal cost: numbers of items times what each costs. All sums are made by chunk,
// whoever works on it, so that shares are no part of a result.
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

/// The cost of a stage for the busiest thread, over the mean.
struct StepBalance {
    int threads = 1;
    double nodes = 1;   ///< nodal forces and integration
    double forces = 1;  ///< contacts, elements, loads; with several ranks of those with ghosts
};

struct StepShares {
    std::vector<StepShare> of_threads;
    StepBalance balance;
};
/// \param s for what has failed and the pair list; none: nothing has
StepShares share_step(const Assemblage& assemblage, const Boundary& boundary, const State* s, int n_threads);

}  // namespace graincrack
