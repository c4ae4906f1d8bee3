// The node stage of a step: forces of elements, contacts, platens and prescribed loads summed in a fixed order, then damping and
// integration, block by block.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Sums the forces on the nodes of a block into `state.force`: contact slots, elements, touches, platens, drives,
/// in this order.
/// With `commit` the platen points remember their friction and the sums take it in; without it nothing but `force` changes.
void sum_nodal_forces(const Assemblage& assemblage, const Boundary& boundary, const StepLoading& loading, std::int32_t block,
                      bool commit, State& state);

/// Damps and integrates the nodes of a block by central differences, v += Δt (F + Fd)/m, u += Δt v, and books the work of
/// damping, platens and loads, each force over the mean of the displacements before and after it. With mass scaling
/// `integrate_clusters` does it, and the work of loads is booked beside it.
void integrate_nodes(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, std::int32_t block,
                     State& state);

/// Books the work of gravity and of loaded edges over half a step at the present velocities.
void book_half_work(const Assemblage& assemblage, const Boundary& boundary, std::int32_t block, double time_step, State& state);

}  // namespace graincrack
