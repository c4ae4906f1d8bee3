// The plan of a run against the run.
#include "solver/run/plan.hpp"

#include <gtest/gtest.h>

#include "solver/run/simulation.hpp"
#include "tests/support/phases.hpp"

namespace graincrack::test {
namespace {

SimulationRequest tension() {
    SimulationRequest r = augig_request(TestKind::tension, 0.5, 0.004);
    r.mass_scaling = true;
    r.save_state = true;
    r.frames = 2;
    return r;
}

const Specimen& specimen() {
    static const Specimen s = jittered_grid(4, 8, 0.02, 0.04, 0.25);
    return s;
}

TEST(Plan, GrowsWithWhatIsKept) {
    SimulationRequest request = tension();
    const SimulationPlan plan = plan_simulation(specimen(), request);
    EXPECT_EQ(plan.nodes, specimen().n_nodes());
    EXPECT_GT(plan.memory, 25e6);
    request.save_state = false;
    EXPECT_LT(plan_simulation(specimen(), request).file_size, plan.file_size);
    request.frames = 20;
    EXPECT_GT(plan_simulation(specimen(), request).file_size, plan.file_size);
}

TEST(Plan, HasNoFewerStepsThanTheRun) {
    SimulationRequest request = tension();
    request.loading.max_strain = 2e-4;  // reached while the platens still speed up and nothing fails
    const SimulationPlan plan = plan_simulation(specimen(), request);
    const TestOutcome outcome = run_test(specimen(), request, "", Verbosity::quiet);
    ASSERT_EQ(outcome.header.stop_reason, "strain limit");
    EXPECT_LE(outcome.header.steps, plan.max_steps);
}

}  // namespace
}  // namespace graincrack::test
