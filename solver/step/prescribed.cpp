#include "solver/step/prescribed.hpp"

#include <cmath>

namespace graincrack {
namespace {

double value_of(const StepLoading& loading, std::int32_t amplitude, double otherwise) {
    return amplitude == no_amplitude || loading.amplitudes.empty() ? otherwise : loading.amplitudes[amplitude];
}

void find_edge_load(const Assemblage& a, const LoadedEdge& edge, const StepLoading& loading, std::int32_t index, State& s) {
    const auto [first, second] = edge.nodes;
    const Vector2 along = (a.position[second] + s.displacement[second]) - (a.position[first] + s.displacement[first]);
    const EdgeLoad load = load_of_edge(edge, along, loading);
    s.prescribed.load[index] = load.on_end;
    s.prescribed.lateral[index] = load.lateral;
}

/// Moves the force on a component into its reaction if the component is prescribed.
void take_reaction(double velocity, double& force, double& reaction) {
    const bool is_prescribed = !std::isnan(velocity);
    reaction = is_prescribed ? -force : 0;
    force = is_prescribed ? 0 : force;
}

/// Moves a component of a node if it is prescribed. \return work of its reaction, J
double move_component(double prescribed, double old_velocity, double reaction, double inertia, double time_step,
                      double old_displacement, double& velocity, double& displacement) {
    if (std::isnan(prescribed)) return 0;
    velocity = prescribed;
    displacement = old_displacement + time_step * prescribed;
    const double force = reaction + inertia * (prescribed - old_velocity);
    return 0.5 * time_step * force * (old_velocity + prescribed);
}

}  // namespace

EdgeLoad load_of_edge(const LoadedEdge& edge, const Vector2& along, const StepLoading& loading) {
    const double half_pressure = 0.5 * value_of(loading, edge.pressure, 0);
    const double half_shear = 0.5 * value_of(loading, edge.shear, 0);
    const double half_length = 0.5 * edge.length;
    const Vector2 load{half_length * value_of(loading, edge.traction[0], 0) - half_pressure * along.y,
                       half_length * value_of(loading, edge.traction[1], 0) + half_pressure * along.x};
    return {load + half_shear * along, half_pressure * std::abs(along.y)};
}

void find_edge_loads(const Assemblage& a, const PrescribedConditions& prescribed, const StepLoading& loading, std::int32_t chunk,
                     State& s) {
    if (prescribed.edges.empty()) return;
    const Range edges = prescribed.edges_of_chunk[chunk];
    for (std::int32_t i = edges.begin; i < edges.end; ++i) find_edge_load(a, prescribed.edges[i], loading, i, s);
}

void add_prescribed(const Assemblage& a, const PrescribedConditions& prescribed, const StepLoading& loading, std::int32_t chunk,
                    State& s) {
    const Range nodes = a.node_chunks[chunk].nodes;
    for (std::int32_t i = nodes.begin; prescribed.has_gravity() && i < nodes.end; ++i) {
        s.force[i] += a.rock_mass[i] * prescribed.gravity;
    }
    const Range ends = prescribed.ends_of_chunk[chunk];
    for (std::int32_t i = ends.begin; i < ends.end; ++i) {
        s.force[prescribed.ends[i].node] += s.prescribed.load[prescribed.ends[i].edge];
    }
    const Range nodes_of_chunk = prescribed.nodes_of_chunk[chunk];
    for (std::int32_t i = nodes_of_chunk.begin; i < nodes_of_chunk.end; ++i) {
        const PrescribedNode& node = prescribed.nodes[i];
        PrescribedState::Node& state = s.prescribed.nodes[i];
        Vector2& force = s.force[node.node];
        state.velocity = {value_of(loading, node.amplitude[0], NAN), value_of(loading, node.amplitude[1], NAN)};
        take_reaction(state.velocity.x, force.x, state.reaction.x);
        take_reaction(state.velocity.y, force.y, state.reaction.y);
    }
}

double load_half_work(const Assemblage& a, const PrescribedConditions& prescribed, std::int32_t chunk, double time_step,
                      const State& s) {
    double work = 0;
    const Range ends = prescribed.ends_of_chunk[chunk];
    for (std::int32_t i = ends.begin; i < ends.end; ++i) {
        work += dot(s.prescribed.load[prescribed.ends[i].edge], s.velocity[prescribed.ends[i].node]);
    }
    Vector2 momentum;
    const Range nodes = a.node_chunks[chunk].nodes;
    for (std::int32_t i = nodes.begin; prescribed.has_gravity() && i < nodes.end; ++i) momentum += a.rock_mass[i] * s.velocity[i];
    return 0.5 * time_step * (work + dot(prescribed.gravity, momentum));
}

double reaction_half_work(const PrescribedConditions& prescribed, std::int32_t chunk, double time_step, const State& s) {
    return 0.5 * time_step * sum_over(prescribed.nodes_of_chunk[chunk], [&](std::int32_t i) {
               return dot(s.prescribed.nodes[i].reaction, s.velocity[prescribed.nodes[i].node]);
           });
}

void record_prescribed(const PrescribedConditions& prescribed, std::int32_t chunk, State& s) {
    if (prescribed.nodes.empty()) return;
    const Range nodes_of_chunk = prescribed.nodes_of_chunk[chunk];
    for (std::int32_t i = nodes_of_chunk.begin; i < nodes_of_chunk.end; ++i) {
        s.prescribed.nodes[i].displacement = s.displacement[prescribed.nodes[i].node];
        s.prescribed.nodes[i].old_velocity = s.velocity[prescribed.nodes[i].node];
    }
}

double move_prescribed(const Assemblage& a, const PrescribedConditions& prescribed, std::int32_t chunk, double time_step,
                       State& s) {
    if (prescribed.nodes.empty()) return 0;
    double work = 0;
    const Range nodes_of_chunk = prescribed.nodes_of_chunk[chunk];
    for (std::int32_t i = nodes_of_chunk.begin; i < nodes_of_chunk.end; ++i) {
        const std::int32_t node = prescribed.nodes[i].node;
        const PrescribedState::Node& n = s.prescribed.nodes[i];
        const double inertia = a.mass[node] / time_step;
        work += move_component(n.velocity.x, n.old_velocity.x, n.reaction.x, inertia, time_step, n.displacement.x,
                               s.velocity[node].x, s.displacement[node].x);
        work += move_component(n.velocity.y, n.old_velocity.y, n.reaction.y, inertia, time_step, n.displacement.y,
                               s.velocity[node].y, s.displacement[node].y);
    }
    return work;
}

}  // namespace graincrack
