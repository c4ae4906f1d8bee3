// The state of a run: all quantities that change in steps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/law/contact_law.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/damping_load.hpp"
#include "solver/model/vertex_clusters.hpp"
#include "solver/ranks/ghost_nodes.hpp"

namespace graincrack {

/// Events of a contact point, in their order if several happen in one step.
enum class ContactEventKind : std::uint8_t {
    failure,     ///< the point passes its peak
    damaged_10,  ///< its remaining cohesion falls below the first of `damage_levels`; the next two likewise
    damaged_50,
    broken,
    separation  ///< the point loses all tensile strength
};

/// An event of a contact point in a step. All members but `peak_traction` are of the end of this step.
struct ContactEvent {
    std::int64_t step = 0;
    std::int32_t contact = 0;
    std::uint8_t point = 0;
    ContactEventKind kind = ContactEventKind::failure;
    CrackMode mode = CrackMode::tensile;  ///< of the first failure
    ContactMotion motion;
    ContactTraction peak_traction;  ///< at a failure the traction of the step before, the last one below the peak
    Vector2 tangent;
    Vector2 position;  ///< middle of the half-edge of the point
};

/// Size of the buffer of events, reserved before the first step. It never grows in a step, as each event of a point occurs once.
inline constexpr std::size_t max_events_per_chunk = 5UL * 2 * contacts_per_chunk;

/// Energies summed over the contacts of a chunk since the start, J.
struct ContactSums {
    double fracture_tension = 0;
    double fracture_shear = 0;
    double friction = 0;
    double non_conservative_work = 0;
    using IsSum = void;
};
/// Energies summed over the nodes of a chunk since the start, J.
struct NodeSums {
    double damping = 0;
    double platen_work = 0;
    double load_work = 0;      ///< of gravity and loaded edges, and initial kinetic energy
    double reaction_work = 0;  ///< of nodes with prescribed motion
    double platen_friction = 0;
    using IsSum = void;
};

/// Thermal work on a chunk of elements. The temperature acts as a generalised displacement; its conjugate force is ∂W/∂T of the
/// stored energy W.
struct ThermalState {
    double temperature = 0;  ///< above the state without stress, K
    double force = 0;  ///< Σ V ∂W/∂T, which is −σ : ∂ε0/∂T per volume in the plane, and the part across it, J/K
    double work = 0;   ///< of the temperature since the start, with the mean force of each step, J
    /// Moves to a temperature and to the force at it.
    void go_to(double new_temperature, double new_force) {
        work += 0.5 * (force + new_force) * (new_temperature - temperature);
        temperature = new_temperature;
        force = new_force;
    }
};

/// The parts of the histories of contact points that `State` does not store in arrays. A chunk of contacts has histories once one
/// of its points has needed the full law; all other points have the history of a new contact.
class PointHistories {
public:
    PointHistories() = default;
    void resize(std::size_t n_points) {
        size_ = n_points;
        chunks_.resize((n_points + points_per_chunk - 1) / points_per_chunk);
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    const ContactHistory& operator[](std::size_t point) const {
        const auto& chunk = chunks_[point / points_per_chunk];
        return chunk.empty() ? new_contact_ : chunk[point % points_per_chunk];
    }
    /// The history of a point to be changed, by the thread that works on its chunk.
    ContactHistory& of(std::size_t point) {
        auto& chunk = chunks_[point / points_per_chunk];
        if (chunk.empty()) chunk.resize(points_per_chunk);
        return chunk[point % points_per_chunk];
    }

private:
    static constexpr std::size_t points_per_chunk = 2UL * contacts_per_chunk;
    static constexpr ContactHistory new_contact_{};
    std::size_t size_ = 0;
    std::vector<std::vector<ContactHistory>> chunks_;
};

struct State {
    std::int64_t step = 0;
    double time = 0;
    std::int64_t origin_step = 0;           ///< the first step with the present time step
    double origin_time = 0;                 ///< of that step, s
    std::vector<Vector2> displacement;      ///< [n] m, at `time`
    std::vector<Vector2> velocity;          ///< [n] m/s, half a step before `time`
    std::vector<Vector2> force;             ///< [n] N, scratch of the node stage
    std::vector<Vector2> last_force;        ///< [n] N, of the step before, for the rate of `force`
    std::vector<Vector2> damping_force;     ///< [n] N, scratch of integration with mass scaling and of measurements
    std::vector<std::uint8_t> near_platen;  ///< [n] 1 + the platen within `platen_reach` of it, else 0; scratch of the node stage
    std::vector<double> contact_force;      ///< slots (`slot_of`), N, at `time`
    std::vector<double> element_force;      ///< slots (`element_slot_of`), N, at `time`; recomputed before the first step
    std::vector<double> opening;            ///< [2 c] m at `time`; as all motions here, over the strength factor of the contact
    std::vector<double> sliding;            ///< [2 c] m at `time`
    std::vector<double> integrity;          ///< [2 c] β of each point; 1 throughout if the law has none
    std::vector<double> slip;               ///< [2 c] frictional slip of each point, m
    std::vector<std::uint8_t> failed;       ///< [2 c] 1 once the point has passed its peak
    std::vector<std::uint8_t> residual;     ///< [2 c] 1 once the point has friction only (`is_residual`)
    std::vector<double> next_level;       ///< [2 c] the first of `damage_levels` that the point has not fallen below; 0 if broken
    PointHistories points;                ///< [2 c] the other parts of the histories of points; see `point_history`
    std::vector<double> fracture_energy;  ///< [2 c] energy dissipated by each point so far, J
    ContactPairList contact_pairs;
    std::vector<double> worn;  ///< [n] slip of the node–edge contacts of a node since the start, m; empty if no face wears
    std::vector<PlatenPoint> platen_points;
    std::vector<NodeSums> node_sums;                ///< by chunk of nodes
    std::vector<ContactSums> contact_sums;          ///< by chunk of contacts
    std::vector<std::vector<ContactEvent>> events;  ///< by chunk of contacts, since last collected; see `max_events_per_chunk`
    std::vector<ThermalState> thermal;              ///< by chunk of elements; empty without a temperature
    std::vector<double> strain_origin;  ///< strains of the three gauges when platens were placed on a heated specimen; else empty
    std::vector<double> energy_origin;  ///< likewise the stored energy, the error of the balance and the external work, J
    StepLoading loading;                ///< at `time`
    ClusterState clusters;              ///< with mass scaling
    PrescribedState prescribed;
    DampingLoad damping_load;
    std::shared_ptr<const GhostNodes> ghosts;  ///< nodes of other ranks that this rank reads; null for a single rank
};

/// The entities of which an array of a state has values. They determine its length and the ranks whose values count.
enum class ArrayOf : std::uint8_t {
    nodes,
    points,  ///< of contacts, two each
    contact_slots,
    element_slots,
    node_chunks,
    contact_chunks,
    // The length of these is known later:
    nodes_once_found,
    node_chunks_once_found,
    element_chunks,
    clusters,
    platen_points,
    pairs,      ///< of the contact pair list
    everywhere  ///< every rank has all values
};
/// Name of an array that is not saved: it is scratch, or recomputed before the first step.
inline constexpr const char* not_saved = "";

/// Calls `visit(name, entities, array)` with each array of a state. Arrays are allocated, gathered from ranks, saved and restored
/// by this list and in its order. A state without a temperature has no thermal arrays.
template <class AnyState, class Visit>
void visit_arrays(AnyState& s, Visit&& visit) {
    using enum ArrayOf;
    visit("displacement", nodes, s.displacement);
    visit("velocity", nodes, s.velocity);
    visit("last_force", nodes, s.last_force);
    visit("mean_displacement", nodes, s.damping_load.mean_displacement);
    visit(not_saved, nodes, s.force);
    visit(not_saved, nodes, s.damping_force);
    visit(not_saved, nodes, s.near_platen);
    visit(not_saved, element_slots, s.element_force);
    visit("contact_slots", contact_slots, s.contact_force);
    visit("opening", points, s.opening);
    visit("sliding", points, s.sliding);
    visit("integrity", points, s.integrity);
    visit("slip", points, s.slip);
    visit("failed", points, s.failed);
    visit("residual", points, s.residual);
    visit("fracture_energy", points, s.fracture_energy);
    visit("platen_points", platen_points, s.platen_points);
    visit("node_sums", node_chunks, s.node_sums);
    visit("contact_sums", contact_chunks, s.contact_sums);
    visit("debonded", everywhere, s.contact_pairs.debonded);
    visit("released", everywhere, s.contact_pairs.released);
    visit("candidate_pairs", pairs, s.contact_pairs.pairs);
    visit("node_edge_contacts", pairs, s.contact_pairs.contacts);
    visit("pair_forces", pairs, s.contact_pairs.forces);
    visit("watched_pairs", pairs, s.contact_pairs.watched);
    visit("pair_friction", node_chunks_once_found, s.contact_pairs.friction);
    visit("displacement_at_search", nodes_once_found, s.contact_pairs.displacement_at_search);
    visit("cluster_load", clusters, s.contact_pairs.cluster_load);
    visit("active_pairs", pairs, s.contact_pairs.active.pair);
    visit("active_counts", pairs, s.contact_pairs.active.count);
    visit("next_mark", points, s.next_level);
    visit("cluster_near_platen", nodes_once_found, s.clusters.near_platen);
    visit("cluster_energies", node_chunks_once_found, s.clusters.sums);
    visit("history", points, s.points);
    if (!s.worn.empty()) visit("worn", nodes, s.worn);
    if (s.thermal.empty()) return;
    visit("thermal", element_chunks, s.thermal);
    visit("strain_origin", everywhere, s.strain_origin);
    visit("energy_origin", everywhere, s.energy_origin);
}

/// Sends displacements and velocities to the ranks that read them; `receive_motion` waits for those that this rank reads.
inline void send_motion(const State& s) {
    s.ghosts->start([&s](std::int32_t i) {
        return std::array{s.displacement[i].x, s.displacement[i].y, s.velocity[i].x, s.velocity[i].y};
    });
}
inline void receive_motion(State& s) {
    s.ghosts->finish([&s](std::int32_t i, const double* numbers) {
        s.displacement[i] = {numbers[0], numbers[1]};
        s.velocity[i] = {numbers[2], numbers[3]};
    });
}

/// Indices of the two points of a contact.
constexpr std::array<std::size_t, 2> points_of(std::int32_t contact) {
    return {2 * static_cast<std::size_t>(contact), 2 * static_cast<std::size_t>(contact) + 1};
}

/// Time of a step, s.
inline double time_of(const State& state, std::int64_t step, double time_step) {
    return state.origin_time + static_cast<double>(step - state.origin_step) * time_step;
}

/// History of contact point 2 c + p. It is always inlined, as is `store_point`: both run for every point that needs the full law.
GRAINCRACK_INLINE ContactHistory point_history(const State& state, std::size_t point) {
    ContactHistory history = state.points[point];
    history.motion = {state.opening[point], state.sliding[point]};
    history.integrity = state.integrity[point];
    history.slip = state.slip[point];
    return history;
}
/// Stores the history of contact point 2 c + p. \param is_residual the result of its law's `is_residual`
GRAINCRACK_INLINE void store_point(const ContactHistory& history, bool is_residual, std::size_t point, State& state) {
    state.points.of(point) = history;
    state.opening[point] = history.motion.opening;
    state.sliding[point] = history.motion.sliding;
    state.integrity[point] = history.integrity;
    state.slip[point] = history.slip;
    state.failed[point] = history.failed() ? 1 : 0;
    state.residual[point] = is_residual ? 1 : 0;
}

/// Returns the state at rest, in which pre-existing cracks are broken.
State make_state(const Assemblage& assemblage, const Boundary& boundary, const Specimen& specimen);

/// Gives a state a temperature, 0 K above the state without stress unless it has one already.
inline void take_temperature(const Assemblage& a, State& s) { s.thermal.resize(a.element_chunks.size()); }

/// Strain and stress of an element at the present displacements, without a temperature.
inline TriangleState cold_element_state(const Assemblage& a, std::size_t e, const State& s) {
    const auto [n0, n1, n2] = a.element_nodes[e];
    return triangle_state(a.element_geometry[e], a.elasticity[e], s.displacement[n1] - s.displacement[n0],
                          s.displacement[n2] - s.displacement[n0]);
}
/// Strain and stress of an element at the present displacements and temperature.
inline TriangleState element_state(const Assemblage& a, std::size_t e, const State& s) {
    if (s.thermal.empty()) return cold_element_state(a, e, s);
    const auto [n0, n1, n2] = a.element_nodes[e];
    const PlaneWarmth warmth = a.expansion.of_element(e, s.loading.temperature);
    return triangle_state(a.element_geometry[e], softened(a.elasticity[e], warmth.softening),
                          s.displacement[n1] - s.displacement[n0], s.displacement[n2] - s.displacement[n0],
                          free_strain(warmth.across, warmth.more_along, a.expansion.axis[e]));
}
/// Stress of an element in the present directions: xx yy xy zz, Pa.
inline std::array<double, 4> element_stress(const Assemblage& a, std::size_t e, const State& s) {
    std::array<double, 4> stress = triangle_stress(a.elasticity[e], element_state(a, e, s));
    if (!s.thermal.empty()) stress[3] -= a.expansion.of_element(e, s.loading.temperature).stress_zz;
    return stress;
}

}  // namespace graincrack
