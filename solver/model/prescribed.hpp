// Prescribed conditions of a program besides platens: velocities of nodes, tractions and pressures on boundary
// edges, gravity. Constant data of a run; the values are amplitudes, functions of time.
//
// A component of a node whose velocity is prescribed is not damped; its reaction is the force that moves it as prescribed,
// R = m Δv/Δt − F. As every force of the scheme, each does its work over the mean of the displacements before and after it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/model/assemblage.hpp"

namespace graincrack {

/// No amplitude, or no boundary condition.
inline constexpr std::int32_t no_amplitude = -1;

/// A node of which a component moves as prescribed while its amplitude is a number; NaN leaves it free.
struct PrescribedNode {
    std::int32_t node = 0;
    std::array<std::int32_t, 2> amplitude{no_amplitude, no_amplitude};  ///< of its velocity along x and y, m/s
    std::array<std::int32_t, 2> condition{no_amplitude, no_amplitude};  ///< the boundary condition that prescribes it
};

/// A boundary edge that carries a load.
struct LoadedEdge {
    std::array<std::int32_t, 2> nodes{};  ///< solid on the left
    std::array<std::int32_t, 2> traction{
        no_amplitude, no_amplitude};       ///< amplitudes of a dead traction along x and y, per reference length, Pa
    std::int32_t pressure = no_amplitude;  ///< amplitude of a pressure that follows the edge, Pa
    std::int32_t shear = no_amplitude;     ///< of a traction along the edge, which follows it, from its first node, Pa
    std::int32_t condition = no_amplitude;
    double length = 0;        ///< reference, m
    bool is_lateral = false;  ///< of the parts left and right of the boundary, whose pressure is the confining pressure
};

/// An end of a loaded edge.
struct LoadedEnd {
    std::int32_t node, edge;
};

/// Sorted by node; ranges by chunk of nodes.
struct PrescribedConditions {
    Vector2 gravity;  ///< m/s²
    std::vector<PrescribedNode> nodes;
    std::vector<Range> nodes_of_chunk;
    std::vector<LoadedEdge> edges;
    std::vector<Range> edges_of_chunk;  ///< by their first nodes
    std::vector<LoadedEnd> ends;
    std::vector<Range> ends_of_chunk;
    [[nodiscard]] bool has_gravity() const { return gravity.x != 0 || gravity.y != 0; }
    [[nodiscard]] bool empty() const { return nodes.empty() && edges.empty() && !has_gravity(); }
};
/// Sorts nodes and edges and finds their ranges.
void arrange_prescribed(const Assemblage& assemblage, PrescribedConditions& prescribed);

/// Reactions and loads of the last step: scratch of the step, which probes read.
struct PrescribedState {
    struct Node {
        Vector2 reaction;      ///< against the other forces, without inertia, N; 0 where free
        Vector2 velocity;      ///< prescribed for the step, m/s; NaN where free
        Vector2 displacement;  ///< before the step, m
        Vector2 old_velocity;  ///< m/s
    };
    std::vector<Node> nodes;
    std::vector<Vector2> load;    ///< of an edge, on each of its ends, N
    std::vector<double> lateral;  ///< the part of it along x that is pressure, inwards positive, N
};

}  // namespace graincrack
