// The node stage of a step: the forces of elements, contacts, platens and prescribed loads are summed in a fixed order, then
// nodes are damped and integrated, chunk by chunk of nodes.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// Sums the forces on all nodes at the present displacements into `state.force`, those of elements and edge loads found anew.
/// Histories and energies stay as they are.
void sum_nodal_forces(const Assemblage& assemblage, const Boundary& boundary, const StepLoading& loading, ThreadTeam& team,
                      State& state);

/// Sums the forces on the nodes of a chunk into `state.force`, in this order: elements, contacts, node–edge contacts, platens,
/// prescribed loads. The friction springs of the platens move to the present displacements, and the friction and the work of the
/// platens are booked, the work as that of their forces over the mean of the platens' displacements before and after.
void advance_nodal_forces(const Assemblage& assemblage, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk,
                          State& state);

/// Damps and integrates the nodes of a chunk by central differences, v += Δt (F + Fd)/m, u += Δt v, and books the work of damping
/// and of the reactions at prescribed nodes. (With mass scaling `integrate_clusters` takes its place.)
void integrate_nodes(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, std::int32_t chunk,
                     State& state);

/// Books the work of gravity and of loaded edges over half a step at the present velocities. A step books it
/// before and after the integration, so that each force works over the mean of the displacements before and after it.
void book_half_load_work(const Assemblage& assemblage, const Boundary& boundary, std::int32_t chunk, double time_step,
                         State& state);

}  // namespace graincrack
