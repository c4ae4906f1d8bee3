// What --sensitivity changes and what it tells; the refined specimen.
#include "solver/run/sensitivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <utility>

#include "mesher/mesh.hpp"
#include "share/file/specimen.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/program/program_file.hpp"
#include "solver/run/simulation.hpp"
#include "solver/setup/setup.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {
namespace {

Specimen refined_disc(int grains, int elements_per_edge) {
    return mesher::mesh({.region = mesher::disc(0.04), .fabric = {.grains = grains, .elements_per_edge = elements_per_edge}});
}

SimulationRequest brazilian() {
    SimulationRequest request;
    request.loading = {.test = TestKind::brazilian, .rate = RateKind::automatic, .platen_friction = 5 * degree};
    request.loading.rate_tolerance = 0.05;  // fast: what is tested is the table
    request.plane = PlaneCondition::stress;
    request.material = augig_granite();
    request.contact = augig_contact(request.plane);
    request.frames = 0;
    return request;
}

// Half the rate, half the time step, half the damping, a quarter of the mass scaling, twice the elements along an edge.
TEST(Sensitivity, ChangesOneSettingEach) {
    SimulationRequest request = brazilian();
    request.mass_scaling = true;
    const Specimen specimen = refined_disc(30, 1);
    const auto axial = [](const SensitivityCase& c) { return *c.request.program->stages.back().platens; };
    const auto cases = sensitivity_cases(request, program_of(request, specimen), 100);
    ASSERT_EQ(cases.size(), 5U);
    EXPECT_EQ(std::get<AutomaticRate>(axial(cases[0])).share, 0.5);
    EXPECT_EQ(std::get<AutomaticRate>(axial(cases[0])).tolerance, 0.05);
    EXPECT_EQ(cases[0].request.time_step_fraction, request.time_step_fraction);
    EXPECT_EQ(cases[1].request.time_step_fraction, request.time_step_fraction / 2);
    EXPECT_FALSE(cases[1].request.program);
    EXPECT_EQ(cases[2].request.damping, 0.4);
    EXPECT_EQ(cases[3].request.mass_scaling_factor, 25);
    EXPECT_TRUE(cases[4].refine);
    EXPECT_FALSE(cases[3].refine);
    request.damping = 0;
    request.loading.rate = RateKind::fixed;
    request.loading.platen_speed = 0.01;
    const auto fewer = sensitivity_cases(request, program_of(request, specimen), 0);
    ASSERT_EQ(fewer.size(), 3U);
    EXPECT_EQ(std::get<TimeFunction>(axial(fewer[0])).value, 0.005);
}

// Ramps and tables are twice as long, speeds half as large; values and ends are the same.
TEST(Sensitivity, DoublesTheTimesOfAProgramAtHalfTheRate) {
    const Program program = parse_program(R"(
name = "cycle"
stages = ["confine", "press"]
damping = 0.8
row_every = "2 us"
platens.max_strain = 0.01
boundary.side = { on = ["left", "right"], pressure = "1 MPa" }
[stage.confine]
side.pressure = { to = "4 MPa", over = "1 ms" }
platen_pressure = { to = "4 MPa", over = "1 ms" }
until = { rest = 0.01, time = "3 ms" }
[stage.press]
platen_speed = { times = [0, "1 ms"], values = [0, "6 mm/s"] }
until = { peak_drop = 0.2, time = "8 ms" }
)",
                                          "cycle.toml");
    const Program slow = at_half_the_rate(program);
    EXPECT_EQ(slow.longest_time(), 2 * program.longest_time());
    EXPECT_EQ(slow.row_interval, 4e-6);
    const TimeFunction& pressure = *slow.stages[0].settings.at("side")[static_cast<std::size_t>(Action::pressure)];
    EXPECT_EQ(pressure.duration, 2e-3);
    EXPECT_EQ(pressure.value, 4e6);
    EXPECT_EQ(std::get<PressureServo>(*slow.stages[0].platens).pressure.duration, 2e-3);
    const auto& speed = std::get<TimeFunction>(*slow.stages[1].platens);
    EXPECT_EQ(speed.times, (std::vector<double>{0, 2e-3}));
    EXPECT_EQ(speed.values, (std::vector<double>{0, 3e-3}));
    EXPECT_EQ(slow.stages[1].peak_drop, 0.2);
}

// The slope from the peak to the last row, (1 − 3)/(1 − 0.5), where the stress fell by the drop.
TEST(Sensitivity, HasThePeakAndTheSlopeBehindIt) {
    RunHeader header;
    header.test = "uniaxial";
    header.peak_axial_stress = 3;
    header.stop_reason = "peak drop";
    History history;
    history[HistoryColumn::axial_stress] = {0, -2, -3, -1};
    history[HistoryColumn::axial_strain] = {0, -0.25, -0.5, -1};
    history[HistoryColumn::tensile_cracks] = {0, 1, 4, 9};
    history[HistoryColumn::shear_cracks] = {0, 0, 2, 3};
    SensitivityRow row = sensitivity_row("unchanged", header, history);
    EXPECT_EQ(row.peak_axial_stress, 3);
    EXPECT_EQ(row.strain_at_peak, 0.5);
    EXPECT_EQ(row.post_peak_slope, -4);
    EXPECT_EQ(row.tensile_cracks, 4);
    EXPECT_EQ(row.shear_cracks, 2);
    header.stop_reason = "strain limit";
    EXPECT_TRUE(std::isnan(sensitivity_row("unchanged", header, history).post_peak_slope));
}

// The rows in the file are those that were computed; a run without --sensitivity has none.
TEST(Sensitivity, IsATableOfTheRun) {
    SimulationRequest request = brazilian();
    request.sensitivity = true;
    const TemporaryFolder folder;
    const SimulationSummary summary = simulate(refined_disc(30, 1), request, folder.file("run.h5"), Verbosity::quiet, {});
    ASSERT_EQ(summary.sensitivity.size(), 5U);
    EXPECT_EQ(summary.sensitivity[0].peak_axial_stress, summary.header.peak_axial_stress);
    EXPECT_NE(summary.sensitivity[1].peak_axial_stress, summary.header.peak_axial_stress);
    const RunReader run(folder.file("run.h5"));
    const auto read = read_sensitivity(run.file());
    ASSERT_EQ(read.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(read[i].changed, summary.sensitivity[i].changed);
        EXPECT_EQ(read[i].peak_axial_stress, summary.sensitivity[i].peak_axial_stress);
        EXPECT_EQ(read[i].shear_cracks, summary.sensitivity[i].shear_cracks);
    }
    EXPECT_TRUE(std::isfinite(read[4].peak_axial_stress));
    request.sensitivity = false;
    simulate(refined_disc(30, 1), request, folder.file("plain.h5"), Verbosity::quiet, {});
    EXPECT_TRUE(read_sensitivity(RunReader(folder.file("plain.h5")).file()).empty());
}

// The nodes are those of the mesher, to the round-off of middles.
TEST(Refinement, GivesTheMeshOfTwiceTheElementsAlongAnEdge) {
    const Specimen fine = refined(refined_disc(50, 1));
    const Specimen made = refined_disc(50, 2);
    EXPECT_NO_THROW(validate(fine, "refined"));
    EXPECT_EQ(fine.n_nodes(), made.n_nodes());
    EXPECT_EQ(fine.n_elements(), made.n_elements());
    EXPECT_EQ(fine.n_contacts(), made.n_contacts());
    EXPECT_EQ(fine.n_boundary_edges(), made.n_boundary_edges());
    EXPECT_EQ(fine.elements_per_edge, 2);
    const auto sorted = [](const Specimen& s) {
        auto points = s.node_position;
        std::sort(points.begin(), points.end());
        return points;
    };
    const auto ours = sorted(fine);
    const auto theirs = sorted(made);
    for (std::size_t i = 0; i < ours.size(); ++i) {
        EXPECT_NEAR(ours[i][0], theirs[i][0], 1e-15);  // middles, to round-off of 0.04 m
    }
    const auto sum = [](const Specimen& s) {
        return std::accumulate(s.contact_grain_boundary.begin(), s.contact_grain_boundary.end(), std::int64_t{0});
    };
    EXPECT_EQ(sum(fine), sum(made));
}

// Contact c becomes 2c and 2c + 1.
TEST(Refinement, LeavesFlawAndStrengthToBothHalvesOfAContact) {
    Specimen coarse = refined_disc(30, 1);
    coarse.flaw_names = {"joint"};
    for (std::size_t c = 0; c < coarse.n_contacts(); ++c) {
        coarse.contact_flaw.push_back(static_cast<std::uint8_t>(c % 2));
        coarse.contact_strength_factor.push_back(1 + 0.01 * static_cast<double>(c));
    }
    const Specimen fine = refined(coarse);
    EXPECT_NO_THROW(validate(fine, "refined"));
    ASSERT_EQ(fine.contact_strength_factor.size(), fine.n_contacts());
    for (std::size_t c = 0; c < fine.n_contacts(); ++c) {
        EXPECT_EQ(fine.contact_flaw[c], coarse.contact_flaw[c / 2]);
        EXPECT_EQ(fine.contact_strength_factor[c], coarse.contact_strength_factor[c / 2]);
    }
}

// Stopped in the test, it resumes from the checkpoint; stopped in the repetitions, the test itself is there.
TEST(Sensitivity, LeavesWhatThereIsWhenStopped) {
    SimulationRequest request = brazilian();
    request.sensitivity = true;
    const TemporaryFolder folder;
    const std::string file = folder.file("run.h5");
    const auto run = [&] { return simulate(refined_disc(30, 1), request, file, Verbosity::quiet, {}); };
    request.stops_after = [](std::size_t rows) { return rows > 20; };
    EXPECT_THROW(run(), Interrupted);
    request.restart = file + ".checkpoint";
    std::size_t most = 0;
    request.stops_after = [&most](std::size_t rows) { return rows < std::exchange(most, std::max(most, rows)); };
    EXPECT_THROW(run(), Interrupted);
    EXPECT_FALSE(std::filesystem::exists(request.restart));
    const RunReader whole(file);
    EXPECT_NE(whole.header().stop_reason, "checkpoint");
    EXPECT_TRUE(read_sensitivity(whole.file()).empty());
    request.restart = "";
    request.stops_after = {};
    EXPECT_EQ(run().header.peak_axial_stress, whole.header().peak_axial_stress);
    EXPECT_EQ(read_sensitivity(RunReader(file).file()).size(), 5U);
}

}  // namespace
}  // namespace graincrack::test
