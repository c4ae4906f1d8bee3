// Who is held together under mass scaling, what changes of it take, and its kinetic energy.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// The clusters of the state as it is, away from platens.
ClusterState make_cluster_state(const Assemblage& assemblage, const MassScaling& scaling, const State& state);

/// Finds what follows from the rest of the state: `whole`, `constrained` and where clusters may change.
void complete_cluster_state(const MassScaling& scaling, State& state);

/// Finds who is held together after the present contact motions and `state.near_platen`; changes velocities where clusters
/// change, and books what they shed.
void update_clusters(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                     std::int32_t chunk, State& state);

/// Takes the added mass away for good, at the present velocities and `state.force`, and books what it sheds.
/// \param time_step of the steps to come, s
void drop_added_mass(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading, double time_step,
                     State& state);

/// Kinetic energy ½ vᵀ(M' − M) v of the added mass of a chunk of clusters, v against the platen where one holds them, J.
double added_kinetic_energy(const Assemblage& assemblage, const StepParameters& parameters, const StepLoading& loading,
                            std::int32_t chunk, const State& state);

}  // namespace graincrack
