// Vertex clusters under mass scaling: constraints by platens, the energy lost when these change, and the energy of the added
// mass.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Computes the parts of the cluster state that follow from the rest of the state. In a new state no cluster is near a platen.
void complete_cluster_state(const Assemblage& assemblage, const MassScaling& scaling, State& state);

/// Finds the clusters of a chunk of nodes that platens constrain, from `state.near_platen`. If this changes, it changes
/// velocities and adds the loss to the sums.
void update_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                     std::int32_t chunk, State& state);

/// Kinetic energy ½ vᵀ(M' − M) v of the added mass of a chunk of nodes, J; v is relative to the platen if one constrains them.
double added_kinetic_energy(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                            std::int32_t chunk, const State& state);

}  // namespace graincrack
