// The state of a run over several ranks as a file keeps it, which knows nothing of ranks: gathered by the first rank, and taken
// apart again by runs over any number of them.
#pragma once

#include <optional>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// The state of all ranks on the first, something on the others. To be made by all.
class WholeState {
public:
    /// \param state that outlives this: of a rank alone, no copy is made
    WholeState(const Assemblage& assemblage, const State& state);
    [[nodiscard]] const State& state() const { return gathered_ ? *gathered_ : own_; }

private:
    const State& own_;
    std::optional<State> gathered_;
};

/// Leaves the pairs that this rank has of a list of all ranks.
void keep_own_pairs(const Assemblage& assemblage, ContactPairList& list);

}  // namespace graincrack
