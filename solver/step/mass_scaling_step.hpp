// Damps and integrates clusters of nodes in a step with mass scaling.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Computes the damping forces of the clusters of a chunk into `state.damping_force` (N). The mean motion of a cluster is damped
/// by the force on the whole cluster, the relative motion of each node by the rest of its force. Contact forces are large against
/// the force on the cluster and would disturb its mean motion if every node were damped by its own force.
void damp_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading, std::int32_t chunk,
                   State& state);

/// Damps and integrates the nodes of a chunk: v += Δt M'⁻¹ (F + Fd), u += Δt v, where M' is the scaled mass matrix and Fd are the
/// damping forces. Adds the energy that damping absorbs and the work of platens on added mass to the sums of the chunk.
void integrate_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                        std::int32_t chunk, State& state);

}  // namespace graincrack
