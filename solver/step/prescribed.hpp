// Prescribed motions and loads in a step, and their work.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/prescribed.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Adds gravity and the edges' loads to `state.force`, then takes the forces off driven components and keeps them as reactions.
void add_prescribed(const Assemblage& assemblage, const PrescribedConditions& prescribed, const StepLoading& loading,
                    std::int32_t chunk, State& state);

/// Work of gravity and of the edges' loads over half a step at the present velocities, J.
double load_half_work(const Assemblage& assemblage, const PrescribedConditions& prescribed, std::int32_t chunk, double time_step,
                      const State& state);
/// Work of the reactions over half a step at the velocities that led here, as if driven nodes went on at them, J.
double reaction_half_work(const PrescribedConditions& prescribed, double time_step, const State& state);

/// Before and after the nodes of a chunk are moved: driven components move as prescribed. \return work of their reactions, J
void hold_prescribed(const PrescribedConditions& prescribed, std::int32_t chunk, State& state);
double move_prescribed(const Assemblage& assemblage, const PrescribedConditions& prescribed, std::int32_t chunk, double time_step,
                       State& state);

}  // namespace graincrack
