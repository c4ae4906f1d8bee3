// The explicit step has five stages: nodal forces (contacts, elements, node–edge contacts, platens, loads), damping and
// integration, platens and amplitudes at the new time, and contact law and node–edge contacts at the new displacements.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// Advances the state by `n_steps` steps under `loading` with a team of threads. Before and after it, contact forces and
/// histories belong to the present displacements (see `start`). The results do not depend on the size of the team.
void advance(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters,
             const IntervalLoading& loading, std::int64_t n_steps, ThreadTeam& team, State& state);

/// Evaluates contacts and vertex clusters at the start, so that `advance` and `measure` use forces of the present displacements.
void start(const Assemblage& assemblage, const StepParameters& parameters, State& state);

}  // namespace graincrack
