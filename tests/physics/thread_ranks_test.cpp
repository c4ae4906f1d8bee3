// Runs on several ranks are the run of one: the same file, to the digest, past the peak, with fragments, whatever the test, the
// law and the mass scaling; so are runs that stop on some ranks and resume on others. Ranks are threads here: see
// tests/end_to_end/ranks.toml for those of MPI.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "solver/program/program_file.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/run/simulation.hpp"
#include "tests/support/crystals.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/same_arrays.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/thread_ranks.hpp"

namespace graincrack::test {
namespace {

/// Crushed until grains come into contact that were not neighbours.
const Specimen& grains_for_ranks() {
    static const Specimen s = jittered_grid(9, 18, 0.04, 0.08, 0.25);
    return s;
}
/// Three phases with classes of contacts for each pair of them.
const Specimen& phases_for_ranks() {
    static const Specimen s = varied_phases(grains_for_ranks()).specimen;
    return s;
}

SimulationRequest request_for_ranks(TestKind test, LawVariant law, bool is_scaled) {
    SimulationRequest r = augig_request(test, is_scaled ? 3 : 10, test == TestKind::tension ? 0.008 : 0.02);
    r.law = law;
    r.mass_scaling = is_scaled;
    r.peak_drop = 0;
    r.frames = 3;
    r.save_state = true;
    return r;
}

/// Writes a run of some ranks.
void run_on_ranks(int n, const Specimen& specimen, SimulationRequest request, const std::string& file) {
    on_thread_ranks(n, [&](const Ranks& ranks) {
        SimulationRequest own = request;
        own.ranks = &ranks;
        simulate(specimen, own, file, Verbosity::quiet, {});
    });
}

std::string digest_of_run(const std::string& file) { return H5Input(file, "run").digest(); }

/// Names the arrays that differ, where the digest does.
void expect_run_as(const std::string& expected, const std::string& file) {
    if (digest_of_run(file) == digest_of_run(expected)) return;
    ADD_FAILURE() << "another digest than that of a rank alone";
    const H5Input differs(file);
    const H5Input right(expected);
    for (const char* group : {"/history", "/cracks", "/state"}) expect_same_arrays(differs, right, group);
}

/// So that what is compared has happened.
void expect_fragments(const std::string& file, std::size_t least_cracks, std::size_t least_contacts) {
    const H5Input run(file);
    EXPECT_GE(run.read<std::int32_t>("/cracks/contact").size(), least_cracks);
    EXPECT_GE(run.read<double>("/state/active_pairs").size(), least_contacts);
    EXPECT_GT(run.read<double>("/history/energy_friction").back(), 0);
}

struct RunOnRanks {
    const char* name;
    Specimen specimen;
    SimulationRequest request;
    std::vector<int> ranks;
    std::size_t least_cracks, least_contacts;
};

std::vector<RunOnRanks> runs_on_ranks() {
    const SimulationRequest pressed = request_for_ranks(TestKind::uniaxial, LawVariant::consistent, true);

    SimulationRequest confined = request_for_ranks(TestKind::triaxial, LawVariant::cohesive_frictional, true);
    confined.material = granite_of_phases();
    confined.loading.confining_pressure = 4e6;
    confined.contact.residual_friction_angle = 0.5 * confined.contact.friction_angle;
    confined.contact.wear_slip = 5e-6;

    SimulationRequest flawed = request_for_ranks(TestKind::uniaxial, LawVariant::coulomb_slip, false);
    flawed.material = granite_with_flaw();

    SimulationRequest torn = request_for_ranks(TestKind::tension, LawVariant::consistent, false);
    torn.peak_drop = 0.7;
    torn.contact.bridging_strength = 0.3 * torn.contact.tensile_strength;
    torn.contact.bridging_energy = 0.2 * torn.contact.fracture_energy;
    torn.threads = 2;

    return {{"fragments", grains_for_ranks(), pressed, {2, 3, 4}, 100, 50},
            {"confined phases", phases_for_ranks(), confined, {2, 4}, 100, 20},
            {"crystals with a flaw", crystals_with_flaw(), flawed, {3}, 100, 20},
            {"torn", grains_for_ranks(), torn, {2, 4}, 20, 0},
            {"two chunks", jittered_grid(4, 8, 0.04, 0.08, 0.25), pressed, {4}, 10, 1}};
}

/// Runs on one rank into one.h5, which must have cracked and rubbed, and expects the same of other numbers of ranks.
void expect_the_run_of_one(const TemporaryFolder& folder, const Specimen& specimen, const SimulationRequest& request,
                           const std::vector<int>& ranks, std::size_t least_cracks, std::size_t least_contacts) {
    run_on_ranks(1, specimen, request, folder.file("one.h5"));
    expect_fragments(folder.file("one.h5"), least_cracks, least_contacts);
    for (const int n : ranks) {
        SCOPED_TRACE(n);
        run_on_ranks(n, specimen, request, folder.file("ranks.h5"));
        expect_run_as(folder.file("one.h5"), folder.file("ranks.h5"));
    }
}

// The digest of the file is that of one rank, past the peak and with fragments.
TEST(ThreadRanks, WriteTheRunOfOne) {
    for (const RunOnRanks& row : runs_on_ranks()) {
        SCOPED_TRACE(row.name);
        expect_the_run_of_one({}, row.specimen, row.request, row.ranks, row.least_cracks, row.least_contacts);
    }
}

const std::string head_of_programs = R"(
name = "cycle"
damping = 0.8
[platens]
[boundary.membrane]
on = ["left", "right"]
[probe.waist]
point = ["0 mm", "0 mm"]
[probe.core]
circle = ["0 mm", "0 mm", "12 mm"]
)";
const std::string stages_before_peak = R"(
[stage.confine]
membrane.pressure = { to = "2 MPa", over = "0.03 ms" }
platen_pressure = { to = "2 MPa", over = "0.03 ms" }
until.time = "0.04 ms"
[stage.press]
platen_speed = { to = "4 m/s", over = "0.02 ms" }
temperature = { to = "30 K", over = "0.04 ms" }
until = { peak_drop = 0.1, time = "0.2 ms" }
)";
const std::string stages_after_peak = R"(
[stage.ease]
membrane.pressure = "keep"
platen_speed = { to = "-1 m/s", over = "0.02 ms" }
until.time = "0.05 ms"
[stage.crush]
membrane.pressure = "keep"
temperature = { to = "10 K", over = "0.1 ms" }
platen_speed = { to = "4 m/s", over = "0.02 ms" }
until.time = "0.25 ms"
)";
SimulationRequest program_for_ranks(const std::string& stages, const std::string& tables) {
    SimulationRequest r = request_for_ranks(TestKind::program, LawVariant::consistent, true);
    r.program = parse_program("stages = [" + stages + "]\n" + head_of_programs + tables, "cycle.toml");
    r.material = granite_of_phases();
    r.material.fabric.phases["quartz"].expansion_along = 7.7e-6;
    r.material.fabric.phases["quartz"].expansion_across = 13.3e-6;
    return r;
}

// Gravity, tractions, prescribed velocities and an initial one: every condition has nodes and edges on the cuts.
TEST(ThreadRanks, RunAProgramOfWavesAsOne) {
    SimulationRequest r = request_for_ranks(TestKind::program, LawVariant::consistent, false);
    r.damping = 0;
    r.program = read_program(GRAINCRACK_SOURCE "/tests/physics/waves.toml");
    expect_the_run_of_one({}, grains_for_ranks(), r, {3, 5}, 10, 0);
}

// From the state of any number of ranks, on any number: the same digest.
TEST(ThreadRanks, StartAProgramFromTheStateThatOthersSaved) {
    const TemporaryFolder folder;
    const SimulationRequest first = program_for_ranks(R"("confine", "press")", stages_before_peak);
    run_on_ranks(1, phases_for_ranks(), first, folder.file("first.h5"));
    run_on_ranks(3, phases_for_ranks(), first, folder.file("first-3.h5"));
    expect_run_as(folder.file("first.h5"), folder.file("first-3.h5"));
    SimulationRequest second = program_for_ranks(R"("ease", "crush")", stages_after_peak);
    second.restart = folder.file("first.h5");
    run_on_ranks(1, phases_for_ranks(), second, folder.file("second.h5"));
    expect_fragments(folder.file("second.h5"), 100, 20);
    second.restart = folder.file("first-3.h5");
    for (const int n : {1, 2}) {
        SCOPED_TRACE(n);
        run_on_ranks(n, phases_for_ranks(), second, folder.file("second-n.h5"));
        expect_run_as(folder.file("second.h5"), folder.file("second-n.h5"));
    }
}

// Stopped four times on 3, 1, 2 and 4 ranks: the digest of the run that was never stopped.
TEST(ThreadRanks, ResumeARunOfOtherRanks) {
    const TemporaryFolder folder;
    const std::string run = folder.file("run.h5");
    SimulationRequest r = request_for_ranks(TestKind::uniaxial, LawVariant::consistent, true);
    run_on_ranks(1, grains_for_ranks(), r, folder.file("whole.h5"));
    expect_fragments(folder.file("whole.h5"), 100, 50);
    const std::size_t rows = RunReader(folder.file("whole.h5")).history().size();
    std::size_t part = 3;
    for (const int n : {3, 1, 2, 4}) {
        r.stops_after = [stop = rows * part++ / 8](std::size_t n_rows) { return n_rows == stop; };
        EXPECT_THROW(run_on_ranks(n, grains_for_ranks(), r, run), Interrupted);
        ASSERT_EQ(std::rename(checkpoint_of(run).c_str(), folder.file("before.h5").c_str()), 0);
        r.restart = folder.file("before.h5");
    }
    r.stops_after = nullptr;
    run_on_ranks(3, grains_for_ranks(), r, run);
    expect_run_as(folder.file("whole.h5"), run);
}

// The first cannot write: no rank goes on without it.
TEST(ThreadRanks, EndWhereTheFirstCannotWrite) {
    const SimulationRequest r = request_for_ranks(TestKind::uniaxial, LawVariant::consistent, true);
    EXPECT_THROW(run_on_ranks(3, grains_for_ranks(), r, "/nowhere/run.h5"), OutputError);
}

}  // namespace
}  // namespace graincrack::test
