// Components of vertex clusters under mass scaling: how they change, the energy lost thereby, the kinetic energy of the added
// mass.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// The components in the present state, away from platens.
ClusterState make_cluster_state(const Assemblage& assemblage, const MassScaling& scaling, const State& state);

/// Finds what follows from the rest of the state: `whole`, `constrained` and where components may change.
void complete_cluster_state(const MassScaling& scaling, State& state);

/// Finds the components of a chunk of clusters after the present contact motions and `state.near_platen`. Where they change it
/// changes velocities and books the regrouping loss.
void update_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                     std::int32_t chunk, State& state);

/// Removes the added mass for good, at the present velocities and `state.force`, and books its kinetic energy as regrouping loss.
/// \param time_step of the steps to come, s
void drop_added_mass(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading, double time_step,
                     State& state);

/// Kinetic energy ½ vᵀ(M' − M) v of the added mass of a chunk of clusters, v relative to the platen where one constrains them, J.
double added_kinetic_energy(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                            std::int32_t chunk, const State& state);

}  // namespace graincrack
