// Vertex clusters under mass scaling: which of them platens constrain, the energy lost when that changes, the kinetic energy of
// the added mass.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Finds what follows from the rest of the state; of a new one, all clusters are away from platens.
void complete_cluster_state(const Assemblage& assemblage, const MassScaling& scaling, State& state);

/// Finds which clusters of a chunk of nodes platens constrain, from `state.near_platen`. Where that changes it changes velocities
/// and books the loss.
void update_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                     std::int32_t chunk, State& state);

/// Kinetic energy ½ vᵀ(M' − M) v of the added mass of a chunk of nodes, v relative to the platen where one constrains them, J.
double added_kinetic_energy(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                            std::int32_t chunk, const State& state);

}  // namespace graincrack
