#include "solver/run/plan.hpp"

#include <array>
#include <tuple>

#include "solver/detection/pair_list.hpp"
#include "solver/model/memory.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/restart/saved_state.hpp"
#include "solver/run/frame.hpp"
#include "solver/run/frame_output.hpp"
#include "solver/run/program_driver.hpp"
#include "solver/setup/setup.hpp"
#include "solver/step/step.hpp"

namespace graincrack {
namespace {

std::size_t size_of_frame(const Frame& frame) {
    const auto& [time, step, displacement, velocity, element_stress, opening, sliding, traction, damage, state] = frame;
    return memory_of_all(displacement, velocity, element_stress, opening, sliding, traction, damage, state);
}

std::size_t size_of_arrays(const Specimen& specimen) {
    const auto& [shape, width, height, tessellation, seed, elements_per_edge, loading_arc, statistics, node_position,
                 element_nodes, element_grain, grain_phase, grain_area, grain_crystal, contact_nodes, contact_grain_boundary,
                 contact_kind, contact_flaw, contact_strength_factor, boundary_edges, boundary_part, phase_names, flaw_names,
                 part_names] = specimen;
    return memory_of_all(node_position, element_nodes, element_grain, grain_phase, grain_area, grain_crystal, contact_nodes,
                         contact_grain_boundary, contact_kind, contact_flaw, contact_strength_factor, boundary_edges,
                         boundary_part);
}

/// The specimen once more as VTK reads it: points, connectivity, offsets and types of its cells, and their three numbers.
std::size_t size_of_vtk_view(const Specimen& specimen) {
    constexpr std::size_t nodes_of_cell = std::tuple_size_v<decltype(specimen.element_nodes)::value_type>;
    const std::size_t integers = nodes_of_cell * specimen.n_elements() + (specimen.n_elements() + 1) + 3;
    return specimen.n_nodes() * sizeof(std::array<double, 3>) + integers * sizeof(std::int64_t) +
           specimen.n_elements() * sizeof(std::uint8_t);
}

template <class... Columns>
constexpr std::size_t size_of_row(const Columns&... /*columns*/) {
    return (sizeof(Columns) + ...);
}
std::size_t size_of_crack() {
    const auto [time, step, contact, point, mode, mode_angle, position, orientation, length, opening, sliding, energy_released,
                damaged_10, damaged_50, broken, separated] = Crack{};
    return size_of_row(time, step, contact, point, mode, mode_angle, position, orientation, length, opening, sliding,
                       energy_released, damaged_10, damaged_50, broken, separated);
}

/// The state in the first step, with histories of all contact points as if all had failed.
State state_with_all_histories(const Specimen& specimen, const Setup& setup) {
    State state = make_state(setup.assemblage, setup.boundary, specimen);
    start(setup.assemblage, setup.parameters, state);
    update_pair_list(setup.assemblage, setup.parameters, state);
    for (std::size_t point = 0; point < state.failed.size(); ++point) state.points.of(point);
    return state;
}

/// Share of the most steps that a test takes at the automatic rate, which is fast until contacts fail. Measured with
/// augig-granite-triangles: uniaxial 1/69, 1/63 (280 grains), 1/59 (twice the tolerance), 1/71 (masses as they are); triaxial at
/// 8 MPa 1/15; direct tension 1/616; Brazilian 1/502. With augig-granite: bending of four beams and two half-discs 1/53 to 1/94.
double usual_share(TestKind test) {
    switch (test) {
        case TestKind::uniaxial: return 1 / 65.0;
        case TestKind::triaxial: return 1 / 15.0;
        case TestKind::tension: return 1 / 600.0;
        case TestKind::brazilian: return 1 / 500.0;
        case TestKind::bend: return 1 / 75.0;
        default: return 0;
    }
}

}  // namespace

SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request) {
    const Program program = program_of(request, specimen);
    const Setup setup = make_setup(specimen, request, program);
    const State state = state_with_all_histories(specimen, setup);
    const ProgramDriver driver(program, request.loading.test, setup.assemblage, specimen, request.material.rock);
    SimulationPlan plan;
    plan.grains = specimen.n_grains();
    plan.elements = specimen.n_elements();
    plan.nodes = specimen.n_nodes();
    plan.contacts = specimen.n_contacts();
    plan.mass_scaling_factor = setup.mass_scaling_factor;
    plan.stable_time_step = setup.stable_time_step;
    plan.time_step = setup.parameters.time_step;
    const LoadingLength length = driver.stages().longest(plan.time_step);
    plan.max_steps = static_cast<std::int64_t>(length.time / plan.time_step);
    if (request.loading.rate == RateKind::automatic) {
        plan.usual_steps = static_cast<std::int64_t>(usual_share(request.loading.test) * static_cast<double>(plan.max_steps));
    }
    plan.rows = length.rows;
    const std::size_t points = 2 * specimen.n_contacts();
    plan.file.specimen = size_of_arrays(specimen) + size_of_vtk_view(specimen);
    plan.file.row = history_datasets.size() * sizeof(double) + driver.size_of_row();
    plan.file.frame = size_of_frame(make_frame(setup.assemblage, setup.parameters.laws, state));
    plan.file.crack = size_of_crack();
    plan.file.saved_state = request.save_state ? size_of_saved_state(state) : 0;
    plan.file_size = plan.file.total(plan.rows, FrameOutput::max_frames(static_cast<std::size_t>(request.frames)), points);
    constexpr std::size_t frames_in_memory = 2;  // that of the peak so far, and the one that is written
    plan.memory = size_of_arrays(specimen) + memory_of(setup.assemblage) + memory_of(setup.boundary) +
                  memory_of(setup.parameters) + memory_of(state) + plan.rows * plan.file.row + points * sizeof(Crack) +
                  frames_in_memory * plan.file.frame;
    return plan;
}

}  // namespace graincrack
