#include "solver/run/plan.hpp"

#include "solver/loading/stage_control.hpp"
#include "solver/loading/standard_tests.hpp"
#include "solver/setup/setup.hpp"

namespace graincrack {

SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request) {
    const Program program = program_of(request, specimen);
    const Setup setup = make_setup(specimen, request, program);
    SimulationPlan plan;
    plan.grains = specimen.n_grains();
    plan.elements = specimen.n_elements();
    plan.nodes = specimen.n_nodes();
    plan.contacts = specimen.n_contacts();
    plan.stable_time_step = setup.stable_time_step;
    plan.time_step = setup.parameters.time_step;
    const LoadingLength length = StageController(program, specimen, request.material.rock).longest(plan.time_step);
    plan.max_steps = static_cast<std::int64_t>(length.time / plan.time_step);
    plan.memory = plan.nodes * (5 * sizeof(Vector2) + 2 * sizeof(double)) + plan.elements * (sizeof(TriangleGeometry) + 16) +
                  plan.contacts * (sizeof(ContactGeometry) + 4 * sizeof(Vector2) + 2 * sizeof(ContactHistory) +
                                   4 * sizeof(std::int32_t) + 16);
    const std::size_t frame = plan.nodes * 32 + plan.elements * 32 + plan.contacts * 82;
    const std::size_t row = 8 * static_cast<std::size_t>(HistoryColumn::count);
    plan.file_size = plan.nodes * 40 + plan.elements * 60 + plan.contacts * 21 + length.rows * row +
                     static_cast<std::size_t>(2 * std::abs(request.frames) + 2) * frame;
    return plan;
}

}  // namespace graincrack
