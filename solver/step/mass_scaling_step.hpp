// The cluster stage of a step with mass scaling: damping and integration.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Damping of the clusters of a chunk, into `state.damping_force`: of the mean motion of each cluster by the force
/// on the whole cluster, and of the relative motion of each node by the rest of its force. (Contact forces are large against
/// the force on the cluster; if every node were damped by its own force they would disturb the mean motion.)
void damp_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                   State& state);

/// Damps and integrates the nodes of a chunk: v += Δt M'⁻¹ (F + Fd), u += Δt v.
void integrate_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                        std::int32_t chunk, State& state);

}  // namespace graincrack
