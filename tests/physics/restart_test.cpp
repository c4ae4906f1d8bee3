// A run that is stopped after every so many rows of its history, and resumes from its checkpoint each time, is the run that was
// never stopped: history, cracks, frames and the state at its end, to the digest.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "mesher/mesh.hpp"
#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/run/simulation.hpp"
#include "tests/support/crystals.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {
namespace {

struct RestartCase {
    const char* name;
    TestKind test;
    RateKind rate;
    double speed;  ///< of a fixed rate, m/s
    bool scaled;
    LawVariant law = LawVariant::consistent;
    bool has_phases = false;    ///< three, with contacts of a pair and strengths that scatter
    bool has_crystals = false;  ///< that break, with a flaw
};
void PrintTo(const RestartCase& c, std::ostream* stream) {  // NOLINT(readability-identifier-naming): as GoogleTest calls it
    *stream << c.name;
}

/// Grains of many shapes, between which node–edge contacts come and go after the peak.
const Specimen& restart_specimen() {
    static const Specimen s = mesher::mesh({.region = mesher::rectangle(0.04, 0.08), .fabric = {.grains = 300}, .seed = 4});
    return s;
}

const Specimen& specimen_of(const RestartCase& c) {
    static const Specimen phased = varied_phases(restart_specimen()).specimen;
    static const Specimen crystals = crystals_with_flaw();
    if (c.has_crystals) return crystals;
    return c.has_phases ? phased : restart_specimen();
}

SimulationRequest restart_request(const RestartCase& c) {
    SimulationRequest r = augig_request(c.test, c.speed, c.test == TestKind::tension ? 0.002 : 0.012);
    if (c.has_phases) r.material = granite_of_phases();
    if (c.has_crystals) r.material = granite_with_flaw();
    r.law = c.law;
    if (c.law == LawVariant::cohesive_frictional || c.test == TestKind::tension) {
        r.contact.bridging_strength = 0.5 * r.contact.tensile_strength;
        r.contact.bridging_energy = 0.5 * r.contact.fracture_energy;
    }
    if (c.law == LawVariant::cohesive_frictional) {
        r.contact.residual_friction_angle = 0.5 * r.contact.friction_angle;
        r.contact.wear_slip = 20e-6;
    }
    r.loading.rate = c.rate;
    r.loading.confining_pressure = c.test == TestKind::triaxial ? 8e6 : 0;
    r.loading.block_steps = 500;
    r.peak_drop = 0.7;
    r.mass_scaling = c.scaled;
    r.frames = 3;
    r.save_state = true;
    return r;
}

std::string run_digest(const std::string& run) { return H5Input(run, "run").digest(); }

// On the clock of this test a row takes one second. Checkpoints are written while the run goes on; here it waits for them.
TEST(Checkpoints, FollowOneAnotherAtTheIntervalThatIsAskedFor) {
    const TemporaryFolder folder;
    const std::string run = folder.file("run.h5");
    SimulationRequest r = restart_request({"uniaxial", TestKind::uniaxial, RateKind::fixed, 0.5, false});
    double time = 0;
    std::size_t checkpoints = 0;
    std::filesystem::file_time_type last;
    r.checkpoint_interval = 100.5;
    r.wall_clock = [&] { return time; };
    r.stops_after = [&](std::size_t rows) {
        time += 1;
        const bool is_due = rows > 1 && rows % 101 == 1;
        std::error_code none;
        auto written = std::filesystem::last_write_time(checkpoint_of(run), none);
        for (int i = 0; is_due && (none || written == last) && i < 1000; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            written = std::filesystem::last_write_time(checkpoint_of(run), none);
        }
        EXPECT_EQ(!none && written != last, is_due) << rows;
        if (!none) last = written;
        checkpoints += is_due ? 1 : 0;
        return false;
    };
    simulate(restart_specimen(), r, run, Verbosity::quiet, {});
    EXPECT_GT(checkpoints, 3U);
}

// Every row gives one to write: that of the stop is begun when that of the row is done.
TEST(Checkpoints, AreThoseOfAStopWhileOthersAreBeingWritten) {
    const TemporaryFolder folder;
    const std::string run = folder.file("run.h5");
    SimulationRequest r = restart_request({"uniaxial", TestKind::uniaxial, RateKind::fixed, 1.0, false});
    r.checkpoint_interval = 0;
    r.stops_after = [](std::size_t rows) { return rows == 20; };
    EXPECT_THROW(simulate(restart_specimen(), r, run, Verbosity::quiet, {}), Interrupted);
    const RunReader checkpoint(checkpoint_of(run));
    EXPECT_EQ(checkpoint.history().size(), 20U);
    EXPECT_EQ(checkpoint.frame(checkpoint.n_frames() - 1).step, checkpoint.header().steps);
}

// Nobody can write them while a folder has the name of what is unfinished.
TEST(Checkpoints, EndARunThatStopsWhereTheyCannotBeWritten) {
    const TemporaryFolder folder;
    const std::string run = folder.file("run.h5"), blocks = checkpoint_of(run) + ".part";
    SimulationRequest r = restart_request({"uniaxial", TestKind::uniaxial, RateKind::fixed, 1.0, false});
    simulate(restart_specimen(), r, folder.file("whole.h5"), Verbosity::quiet, {});
    std::filesystem::create_directory(blocks);
    r.checkpoint_interval = 0;
    testing::internal::CaptureStderr();
    simulate(restart_specimen(), r, run, Verbosity::normal, {});
    std::istringstream said(testing::internal::GetCapturedStderr());
    std::string warnings;
    for (std::string line; std::getline(said, line);) warnings += line.find("warning") < line.size() ? line + "\n" : "";
    expect_golden(warnings);
    EXPECT_EQ(run_digest(run), run_digest(folder.file("whole.h5")));
    r.stops_after = [](std::size_t rows) { return rows == 20; };
    EXPECT_THROW(simulate(restart_specimen(), r, run, Verbosity::quiet, {}), OutputError);
    r.stops_after = [&](std::size_t rows) {
        if (rows == 10) std::filesystem::remove(blocks);
        return rows == 20;
    };
    EXPECT_THROW(simulate(restart_specimen(), r, run, Verbosity::quiet, {}), Interrupted);
    EXPECT_EQ(RunReader(checkpoint_of(run)).history().size(), 20U);
}

class Restart : public testing::TestWithParam<RestartCase> {};

// History, cracks, frames and the saved state have the digest of the run that was never stopped.
TEST_P(Restart, GivesTheSameRunAfterEverySoManyRows) {
    const TemporaryFolder folder;
    const std::string whole = folder.file("whole.h5");
    const SimulationSummary summary = simulate(specimen_of(GetParam()), restart_request(GetParam()), whole, Verbosity::quiet, {});
    const std::size_t rows = RunReader(whole).history().size();
    EXPECT_GT(summary.cracks.tensile + summary.cracks.shear, 10U);  // so that what is compared has happened
    const std::string run = folder.file("run.h5");
    const std::string before = folder.file("before.h5");
    // Densely where node–edge contacts come and go.
    std::vector<std::size_t> stops;
    for (std::size_t stop = rows / 5; stop < rows; stop += stop < rows * 7 / 10 ? rows / 5 : rows / 200 + 1) {
        stops.push_back(stop);
    }
    std::string restart;
    std::size_t restarts = 0;
    for (const std::size_t stop : stops) {
        SimulationRequest r = restart_request(GetParam());
        r.threads = 1 + static_cast<int>(restarts % 2);
        r.restart = restart;
        r.stops_after = [stop](std::size_t n) { return n == stop; };
        EXPECT_THROW(simulate(specimen_of(GetParam()), r, run, Verbosity::quiet, {}), Interrupted);
        ASSERT_EQ(RunReader(checkpoint_of(run)).history().size(), stop);
        ASSERT_EQ(std::rename(checkpoint_of(run).c_str(), before.c_str()), 0);
        restart = before;
        ++restarts;
    }
    EXPECT_GE(restarts, 10U);
    SimulationRequest r = restart_request(GetParam());
    r.restart = restart;
    simulate(specimen_of(GetParam()), r, run, Verbosity::quiet, {});
    EXPECT_EQ(run_digest(run), run_digest(whole));
}

INSTANTIATE_TEST_SUITE_P(OfATest, Restart,
                         testing::Values(RestartCase{"UniaxialUnscaled", TestKind::uniaxial, RateKind::fixed, 1.0, false},
                                         RestartCase{"UniaxialAuto", TestKind::uniaxial, RateKind::automatic, 0, true},
                                         RestartCase{"UniaxialCohesiveFrictional", TestKind::uniaxial, RateKind::fixed, 1.0,
                                                     false, LawVariant::cohesive_frictional},
                                         RestartCase{"UniaxialThreePhases", TestKind::uniaxial, RateKind::fixed, 1.0, true,
                                                     LawVariant::consistent, true},
                                         RestartCase{"UniaxialCrystalsWithAFlaw", TestKind::uniaxial, RateKind::fixed, 1.0, true,
                                                     LawVariant::consistent, false, true},
                                         RestartCase{"TriaxialScaled", TestKind::triaxial, RateKind::fixed, 1.0, true},
                                         RestartCase{"TriaxialBlocks", TestKind::triaxial, RateKind::blocks, 0.5, true},
                                         RestartCase{"Tension", TestKind::tension, RateKind::fixed, 0.3, true}),
                         [](const testing::TestParamInfo<RestartCase>& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace graincrack::test
