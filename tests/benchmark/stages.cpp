#include "tests/benchmark/stages.hpp"
#include "solver/step/contact_forces.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "tests/support/small_run.hpp"

#include <utility>

namespace graincrack::benchmark {
namespace {

constexpr double speed = 0.05;  // of each platen, m/s

LoadingRequest compression() {
    LoadingRequest request;
    request.platen_friction = 5 * test::degree;
    return request;
}

template <class Act>
void for_each_chunk(std::size_t n, Act&& act) {
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(n); ++chunk) act(chunk);
}

void contacts(LoadedSpecimen& l) {
    for_each_chunk(l.assemblage.contact_chunks.size(),
                   [&](std::int32_t chunk) { advance_contacts(l.assemblage, l.parameters.laws, chunk, l.state.step, l.state); });
}
void forces(LoadedSpecimen& l) { sum_nodal_forces(l.assemblage, l.boundary, l.state.loading, l.state); }
void nodes(LoadedSpecimen& l) {
    StepParameters still = l.parameters;
    still.time_step = 0;  // as much work, and the state stays
    for_each_chunk(l.assemblage.node_chunks.size(), [&](std::int32_t chunk) {
        book_half_load_work(l.assemblage, l.boundary, chunk, 0, l.state);
        integrate_nodes(l.assemblage, l.boundary, still, chunk, l.state);
        book_half_load_work(l.assemblage, l.boundary, chunk, 0, l.state);
    });
}
void clusters(LoadedSpecimen& l) {
    const double time_step = std::exchange(l.parameters.time_step, 0.0);
    for_each_chunk(l.assemblage.node_chunks.size(), [&](std::int32_t chunk) {
        update_clusters(l.assemblage, l.parameters, l.state.loading, chunk, l.state);
        integrate_clusters(l.assemblage, l.parameters, l.state.loading, chunk, l.state);
    });
    l.parameters.time_step = time_step;
}

}  // namespace

LoadedSpecimen::LoadedSpecimen(Specimen s, LawVariant law, bool scaled, VectorTarget vector_target)
    : specimen(std::move(s)),
      assemblage(make_assemblage(specimen, test::augig_granite().rock, PlaneCondition::strain)),
      parameters{make_contact_law(test::augig_contact(), law, Coupling::full), 0, 0.8},
      boundary(test::boundary_of_test(assemblage, specimen, compression(), test::augig_contact())) {
    assemblage.vector_target = vector_target;
    const double factor = scaled ? sufficient_mass_scaling(assemblage, boundary, parameters.laws) : 0;
    parameters.mass_scaling = make_mass_scaling(assemblage, factor);
    parameters.time_step = 0.7 * stable_time_step(assemblage, boundary, parameters.laws, factor);
    state = make_state(assemblage, boundary, specimen);
    for (std::size_t i = 0; i < state.velocity.size(); ++i) {
        state.velocity[i] = {0, -2 * speed * assemblage.position[i].y / specimen.height};
    }
    start(assemblage, parameters, state);
    ThreadTeam alone(1);
    advance_by(2000, alone);
}

void LoadedSpecimen::advance_by(std::int64_t steps, ThreadTeam& team) {
    const IntervalLoading loading{{speed, -speed}, {speed, -speed}, nullptr};
    advance(assemblage, boundary, parameters, loading, steps, team, state);
}

std::vector<Stage> stages_of(const LoadedSpecimen& l) {
    const double contacts_of_grain = static_cast<double>(l.assemblage.n_contacts()) / l.grains();
    const double elements_of_grain = static_cast<double>(l.assemblage.n_elements()) / l.grains();
    const double nodes_of_grain = static_cast<double>(l.assemblage.n_nodes()) / l.grains();
    // Frame 12, motion 6 a point, law 45 a point (18 of them e^(−x)), booking 4 a point, forces 36.
    const double of_contact = 12 + 36 + 2 * (6 + 45 + 4);
    // Geometry 40; motion, cohesion and energy of two points read and written 2 · 2 · 32; slots 64; four nodes' displacements,
    // each of which two contacts share, 32.
    const double bytes_of_contact = 40 + 128 + 64 + 32;
    // Gradient of displacement 12, polar decomposition 14, strain and stress 22, forces 24; and 8 for the sum.
    const double of_element = 80;
    const double bytes_of_element = 12 + 40;
    std::vector<Stage> stages{{"contact law", of_contact * contacts_of_grain, bytes_of_contact * contacts_of_grain, contacts},
                              {"elements and sum at nodes", of_element * elements_of_grain + 2 * nodes_of_grain,
                               bytes_of_element * elements_of_grain + (8 + 32 + 16 + 16 + 1) * nodes_of_grain, forces}};
    if (l.parameters.mass_scaling.is_on()) {
        // Two means and two damping forces of two components each, 2 · 26 operations; force, velocity, displacement, masses and
        // places.
        stages.push_back({"integration of clusters", 52 * nodes_of_grain, (16 + 32 + 32 + 32 + 8) * nodes_of_grain, clusters});
    } else {
        stages.push_back({"integration", 22 * nodes_of_grain, (16 + 32 + 32 + 8) * nodes_of_grain, nodes});
    }
    return stages;
}

}  // namespace graincrack::benchmark
