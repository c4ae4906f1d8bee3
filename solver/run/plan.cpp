#include "solver/run/plan.hpp"

#include "solver/program/standard_tests.hpp"
#include "solver/run/frame_output.hpp"
#include "solver/run/program_driver.hpp"
#include "solver/setup/setup.hpp"

namespace graincrack {
namespace {

// Bytes a node, measured of triangles (300, 5,000 and 20,000 grains), of 300 crystals of 8 elements and of 1,000 polygonal grains
// in uniaxial tests: a grain of one element has three nodes. Node–edge contacts of a crushed specimen take some 300 more.
constexpr double memory_of_node = 1100;  // 890 to 1,000, and 95 of a frame that is being written
constexpr double file_of_node = 370;     // specimen and crack log: 350 to 370
constexpr double frame_of_node = 95;     // 83 to 94
constexpr double state_of_node = 310;    // 280 to 310
constexpr double memory_of_program = 25e6;
constexpr double size_of_history = 2e6;  // of 8,000 rows, which a test to its strain limit has

}  // namespace

SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request) {
    const Program program = program_of(request, specimen);
    const Setup setup = make_setup(specimen, request, program);
    const ProgramDriver driver(program, request.loading.test, setup.assemblage, specimen, request.material.rock);
    SimulationPlan plan;
    plan.grains = specimen.n_grains();
    plan.elements = specimen.n_elements();
    plan.nodes = specimen.n_nodes();
    plan.contacts = specimen.n_contacts();
    plan.mass_scaling_factor = setup.mass_scaling_factor;
    plan.stable_time_step = setup.stable_time_step;
    plan.time_step = setup.parameters.time_step;
    plan.balance = share_step(setup.assemblage, setup.boundary, nullptr, request.threads_for(plan.elements)).balance;
    const LoadingLength length = driver.stages().longest();
    plan.max_steps = static_cast<std::int64_t>(length.time / plan.time_step);
    if (request.loading.rate == RateKind::automatic) {
        const double fraction = description_of(request.loading.test).usual_fraction;
        const auto of_heating = static_cast<std::int64_t>(length.heating / plan.time_step);
        plan.usual_steps = static_cast<std::int64_t>(fraction * static_cast<double>(plan.max_steps - of_heating)) +
                           static_cast<std::int64_t>(length.usual_heating / plan.time_step);
    }
    const auto nodes = static_cast<double>(plan.nodes);
    const auto frames = static_cast<double>(FrameOutput::max_frames(static_cast<std::size_t>(request.frames)));
    plan.memory = memory_of_program + memory_of_node * nodes + size_of_history;
    plan.file_size = (file_of_node + frame_of_node * frames + (request.save_state ? state_of_node : 0)) * nodes + size_of_history;
    return plan;
}

}  // namespace graincrack
