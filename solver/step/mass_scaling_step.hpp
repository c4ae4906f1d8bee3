// The cluster stage of a step with mass scaling: damping and integration.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Damping of a chunk of clusters, into `state.damping_force`: of the mean motion of those held together against the force
/// on all of them, and of the motion about it against what is left of each one's force. Each has the inertia that goes with it:
/// the forces in the contacts, huge against the mean's, would shake the mean if every node were damped by its own.
void damp_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                   State& state);

/// Damps and integrates the nodes of a chunk of clusters: v += Δt M'⁻¹ (F + Fd), u += Δt v.
void integrate_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                        std::int32_t chunk, State& state);

}  // namespace graincrack
