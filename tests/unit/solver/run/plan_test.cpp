// The plan of a run against the run.
#include "solver/run/plan.hpp"

#include <gtest/gtest.h>

#include "solver/run/simulation.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack {
namespace {

SimulationRequest tension() {
    SimulationRequest r;
    r.material = test::augig_granite();
    r.contact = test::augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i);
    r.loading.test = TestKind::tension;
    r.loading.platen_speed = 0.5;
    r.loading.max_strain = 0.004;
    r.mass_scaling = true;
    r.save_state = true;
    r.frames = 2;
    return r;
}

const Specimen& specimen() {
    static const Specimen s = test::jittered_grid(4, 8, 0.02, 0.04, 0.25);
    return s;
}

TEST(Plan, SizesGrowWithWhatIsKept) {
    SimulationRequest request = tension();
    const SimulationPlan plan = plan_simulation(specimen(), request);
    EXPECT_EQ(plan.nodes, specimen().n_nodes());
    EXPECT_GT(plan.memory, 25e6);
    request.save_state = false;
    EXPECT_LT(plan_simulation(specimen(), request).file_size, plan.file_size);
    request.frames = 20;
    EXPECT_GT(plan_simulation(specimen(), request).file_size, plan.file_size);
}

TEST(Plan, NoRunHasMoreSteps) {
    SimulationRequest request = tension();
    request.loading.max_strain = 2e-4;  // reached while the platens still speed up and nothing fails
    const SimulationPlan plan = plan_simulation(specimen(), request);
    const TestOutcome outcome = run_test(specimen(), request, "", Verbosity::quiet);
    ASSERT_EQ(outcome.header.stop_reason, "strain limit");
    EXPECT_LE(outcome.header.steps, plan.max_steps);
}

}  // namespace
}  // namespace graincrack
