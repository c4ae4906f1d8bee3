// Applies prescribed motions and loads in a step, and computes their work.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/prescribed.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Load of an edge. \param along vector from its first node to its second, m
struct EdgeLoad {
    Vector2 on_end;      ///< force on each of its nodes, N
    double lateral = 0;  ///< its component along x due to pressure, positive inwards, N
};
EdgeLoad load_of_edge(const LoadedEdge& edge, const Vector2& along, const StepLoading& loading);

/// Computes the loads of the edges of a chunk at the present displacements.
void find_edge_loads(const Assemblage& assemblage, const PrescribedConditions& prescribed, const StepLoading& loading,
                     std::int32_t chunk, State& state);

/// Adds gravity and the loads of edges to `state.force`, then moves the force on each prescribed component into its reaction.
void add_prescribed(const Assemblage& assemblage, const PrescribedConditions& prescribed, const StepLoading& loading,
                    std::int32_t chunk, State& state);

/// Work of gravity and of the edges' loads over half a step at the present velocities, J.
double load_half_work(const Assemblage& assemblage, const PrescribedConditions& prescribed, std::int32_t chunk, double time_step,
                      const State& state);
/// Work of the reactions over half a step at the present velocities of the prescribed nodes of a chunk, J.
double reaction_half_work(const PrescribedConditions& prescribed, std::int32_t chunk, double time_step, const State& state);

/// Stores displacements and velocities of the prescribed nodes of a chunk before the integration.
void record_prescribed(const PrescribedConditions& prescribed, std::int32_t chunk, State& state);
/// Moves prescribed components as prescribed, after the integration. \return work of their reactions, J
double move_prescribed(const Assemblage& assemblage, const PrescribedConditions& prescribed, std::int32_t chunk, double time_step,
                       State& state);

}  // namespace graincrack
