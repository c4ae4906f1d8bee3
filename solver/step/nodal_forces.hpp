// The node stage of a step: forces of elements, contacts, platens and membrane summed in a fixed order, then damping and
// integration, chunk by chunk.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Sums the forces on the nodes of a chunk into `state.force`: contact slots, elements, touches, platens, membrane, drives,
/// in this order.
/// With `commit` the platen points remember their friction and the sums take it in; without it nothing but `force` changes.
void sum_nodal_forces(const Assemblage& assemblage, const Boundary& boundary, const StepLoading& loading, std::int32_t chunk,
                      bool commit, State& state);

/// Damps and integrates the nodes of a chunk by central differences, v += Δt (F + Fd)/m, u += Δt v, and books the work of
/// damping, platens and membrane, each force over the mean of the displacements before and after it. With mass scaling
/// `integrate_clusters` does it, and the membrane's work is booked beside it.
void integrate_nodes(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, std::int32_t chunk,
                     State& state);

/// Books the work of the membrane, of gravity and of loaded edges over half a step at the present velocities.
void book_half_work(const Assemblage& assemblage, const Boundary& boundary, std::int32_t chunk, double time_step, State& state);

}  // namespace graincrack
