// The node stage of a step, chunk by chunk of nodes: sums the forces of elements, contacts, platens and prescribed loads in a
// fixed order, then damps and integrates the nodes.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// Sums the forces on all nodes at the present displacements into `state.force` (N), with new element forces and edge loads.
/// Histories and energies do not change.
void sum_nodal_forces(const Assemblage& assemblage, const Boundary& boundary, const StepLoading& loading, ThreadTeam& team,
                      State& state);

/// Sums the forces on the nodes of a chunk into `state.force` (N), in this order: elements, contacts, node–edge contacts,
/// platens, prescribed loads. It moves the friction springs of the platens to the present displacements and adds their friction
/// and the work of the platens to the sums. That work is the force times the mean of the platens' displacements before and after.
void advance_nodal_forces(const Assemblage& assemblage, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk,
                          State& state);

/// Damps and integrates the nodes of a chunk by central differences, v += Δt (F + Fd)/m, u += Δt v. It adds the work of damping
/// and of the reactions at prescribed nodes to the sums. With mass scaling `integrate_clusters` replaces it.
void integrate_nodes(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, std::int32_t chunk,
                     State& state);

/// Adds the work of gravity and of loaded edges over half a step at the present velocities to the sums. A step calls it before
/// and after the integration, so that each force works over the mean of the displacements before and after it.
void book_half_load_work(const Assemblage& assemblage, const Boundary& boundary, std::int32_t chunk, double time_step,
                         State& state);

}  // namespace graincrack
