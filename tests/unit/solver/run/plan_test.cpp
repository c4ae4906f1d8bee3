// The plan of a run against the run: the arrays of its file, and the memory of its structures.
#include "solver/run/plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <sstream>

#include "share/file/h5_file.hpp"
#include "share/file/run_file.hpp"
#include "share/file/schema.hpp"
#include "solver/run/simulation.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

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

/// Bytes of the arrays in a line of `H5Input::describe`: path, type, shape in brackets.
std::size_t size_of(const std::string& line) {
    static const std::map<std::string, std::size_t> size_of_type{{"float64", 8}, {"int64", 8}, {"int32", 4}, {"uint8", 1}};
    std::istringstream words(line);
    std::string path;
    std::string type;
    std::string shape;
    words >> path >> type >> shape;
    const bool is_link = path.find("PointData") != std::string::npos || path.find("CellData") != std::string::npos;
    if (is_link || shape.empty() || shape.front() != '[' || !size_of_type.contains(type)) return 0;
    std::size_t size = size_of_type.at(type);
    std::istringstream extents(shape.substr(1));
    for (std::size_t extent = 0; extents >> extent; extents.ignore()) size *= extent;
    return size;
}

/// Bytes of the arrays of a file by their groups.
std::map<std::string, std::size_t> sizes_in(const H5Input& file) {
    std::map<std::string, std::size_t> sizes;
    for (const std::string& line : file.describe()) {
        const std::size_t begin = line.find('/');
        if (begin != std::string::npos) sizes[line.substr(begin, line.find('/', begin + 1) - begin)] += size_of(line);
    }
    return sizes;
}

TEST(Plan, FileSizeIsThatOfTheArraysThatTheRunWrites) {
    const test::TemporaryFolder folder;
    const SimulationPlan plan = plan_simulation(specimen(), tension());
    simulate(specimen(), tension(), folder.file("run.h5"), Verbosity::quiet, {});
    const RunReader run(folder.file("run.h5"));
    std::map<std::string, std::size_t> sizes = sizes_in(run.file());
    const std::size_t rows = run.history().size();
    const std::size_t cracks = run.cracks().size();
    ASSERT_GT(cracks, 0U);
    EXPECT_EQ(sizes["/history"], rows * plan.file.row);
    EXPECT_EQ(sizes["/frames"], run.n_frames() * plan.file.frame);
    EXPECT_EQ(sizes["/cracks"], cracks * plan.file.crack);
    EXPECT_EQ(
        sizes["/nodes"] + sizes["/elements"] + sizes["/grains"] + sizes["/contacts"] + sizes["/boundary"] + sizes["/VTKHDF"],
        plan.file.specimen);
    std::size_t total = 0;
    for (const auto& [group, size] : sizes) total += size;
    // The saved state may have more node–edge contacts than the start.
    EXPECT_GE(total, plan.file.total(rows, run.n_frames(), cracks));
    EXPECT_LE(static_cast<double>(total), 1.02 * static_cast<double>(plan.file.total(rows, run.n_frames(), cracks)));
    EXPECT_LE(total, plan.file_size);
}

TEST(Plan, NoRunHasMoreStepsAndRows) {
    SimulationRequest request = tension();
    request.loading.max_strain = 2e-4;  // reached while the platens still speed up and nothing fails
    const SimulationPlan plan = plan_simulation(specimen(), request);
    const TestOutcome outcome = run_test(specimen(), request, "", Verbosity::quiet);
    ASSERT_EQ(outcome.header.stop_reason, "strain limit");
    EXPECT_LE(outcome.header.steps, plan.max_steps);
    EXPECT_LE(outcome.history.size(), plan.rows);
}

TEST(Plan, SavedStateCountsWhereItIsKept) {
    SimulationRequest without = tension();
    without.save_state = false;
    const SimulationPlan plan = plan_simulation(specimen(), tension());
    const SimulationPlan other = plan_simulation(specimen(), without);
    EXPECT_EQ(other.file.saved_state, 0U);
    EXPECT_EQ(plan.file_size, other.file_size + plan.file.saved_state);
}

TEST(Plan, MemoryHoldsTheStructuresOfTheRun) {
    const SimulationPlan plan = plan_simulation(specimen(), tension());
    test::SmallRun run(specimen(), test::augig_law());
    run.begin();
    const std::size_t structures = memory_of(run.assemblage) + memory_of(run.state);
    EXPECT_GT(plan.memory, structures + plan.rows * history_datasets.size() * sizeof(double));
    SimulationRequest request = tension();
    request.mass_scaling = false;
    const SimulationPlan unscaled = plan_simulation(specimen(), request);
    EXPECT_GT(plan.memory - plan.rows * plan.file.row, unscaled.memory - unscaled.rows * unscaled.file.row)
        << "vertex clusters take memory";
}

// A member that is missing in `memory_of` does not compile; one that is not passed on is seen here.
TEST(Memory, GrowsByEveryArrayOfAState) {
    test::SmallRun run(specimen(), test::augig_law());
    run.begin();
    State& s = run.state;
    std::size_t before = memory_of(s);
    const auto expect_growth = [&](auto& items) {
        items.resize(items.size() + 1);
        EXPECT_EQ(memory_of(s), before + sizeof(items.back()));
        before = memory_of(s);
    };
    for (auto* vectors :
         {&s.displacement, &s.velocity, &s.force, &s.last_force, &s.damping_force, &s.damping_load.mean_displacement,
          &s.prescribed.load, &s.contact_pairs.forces, &s.contact_pairs.displacement_at_search}) {
        expect_growth(*vectors);
    }
    for (auto* values :
         {&s.contact_force, &s.element_force, &s.opening, &s.sliding, &s.integrity, &s.slip, &s.fracture_energy,
          &s.loading.amplitudes, &s.prescribed.lateral, &s.clusters.inverse_mass, &s.contact_pairs.active.overlap}) {
        expect_growth(*values);
    }
    for (auto* flags : {&s.near_platen, &s.failed, &s.residual, &s.contact_pairs.released, &s.clusters.near_platen}) {
        expect_growth(*flags);
    }
    expect_growth(s.platen_points);
    expect_growth(s.node_sums);
    expect_growth(s.contact_sums);
    expect_growth(s.contact_pairs.pairs);
    expect_growth(s.events.front());
    expect_growth(s.events);
    s.points.of(0);
    EXPECT_EQ(memory_of(s), before + 2UL * contacts_per_chunk * sizeof(ContactHistory)) << "histories come by chunk";
}

TEST(Memory, GrowsByTheArraysOfTheAssemblage) {
    test::SmallRun run(specimen(), test::augig_law());
    const std::size_t before = memory_of(run.assemblage);
    run.assemblage.contacts.resize(run.assemblage.contacts.size() + 3);
    run.assemblage.surface.edges.resize(run.assemblage.surface.edges.size() + 2);
    run.assemblage.element_geometry.area.push_back(1);
    EXPECT_EQ(memory_of(run.assemblage), before + 3 * sizeof(ContactGeometry) + 2 * sizeof(SurfaceEdge) + sizeof(double));
}

}  // namespace
}  // namespace graincrack
