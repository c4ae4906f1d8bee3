// Runs that are heated: their energy balance, what their files keep, resuming, and strength after heating.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "share/base/error.hpp"
#include "share/file/fabric.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/peak.hpp"
#include "share/file/schema.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/run/simulation.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

/// Free grains of three minerals that are heated and cooled. \param middle the temperature between
std::string heat_and_cool(const std::string& middle) {
    return R"(name = "heat"
        stages = ["heat", "middle", "cool"]
        damping = 0.8
        stage.heat = { temperature = { to = "400 K", over = "0.2 ms" }, until = { time = "0.2 ms" } }
        stage.cool = { temperature = { to = 0, over = "0.2 ms" }, until = { time = "0.22 ms" } }
        stage.middle = { until = { time = "0.02 ms" }, temperature = )" +
           middle + "}";
}
PhasedSpecimen expanding_minerals() {
    PhasedSpecimen varied = varied_phases(jittered_grid(8, 12, 0.02, 0.03, 0.25));
    for (std::size_t p = 0; p < 3; ++p) varied.fabric.phases[p].thermal_expansion = 12e-6 - 5e-6 * static_cast<double>(p);
    return varied;
}

/// Three minerals, two of whose crystals have axes, one of which changes with temperature; all soften.
PhasedSpecimen minerals_with_axes() {
    PhasedSpecimen varied = varied_phases(jittered_grid(8, 12, 0.02, 0.03, 0.25));
    varied.specimen.seed = 7;
    for (Phase& phase : varied.fabric.phases) phase.softening = {{0, 1}, {480, 0.7}};
    varied.fabric.phases[0].along = {{0, 7.7e-6}, {480, 12e-6}};
    varied.fabric.phases[0].across = {{0, 13.3e-6}, {480, 25e-6}};
    varied.fabric.phases[1].along = {{0, 15e-6}};
    varied.fabric.phases[1].across = {{0, 3e-6}};
    varied.fabric.phases[2].thermal_expansion = 9e-6;
    return varied;
}
// Without failures to the change of contacts' stiffness, also where expansion is curved and the temperature jumps, or where
// crystals have axes; with failures as for other loads.
TEST(HeatedRun, ClosesItsEnergyBalance) {
    const PhasedSpecimen straight = expanding_minerals();
    PhasedSpecimen curved = straight;  // the expansion of one mineral triples, another's modulus falls
    curved.fabric.phases[0].along = curved.fabric.phases[0].across = {{0, 8e-6}, {200, 9e-6}, {400, 24e-6}};
    curved.fabric.phases[1].softening = {{0, 1}, {400, 0.7}};
    const std::string name = "phases: residual of the energy balance over stored energy, ";
    const std::string source = "each term by its own definition";
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        const auto run = [&](double strength, double damping, const char* middle, const PhasedSpecimen& grains) {
            const ContactParameters contact = scaled_contact(augig_contact(), strength);
            ProgramRun heated(grains.specimen, heat_and_cool(middle), make_contact_law(contact, LawVariant::consistent), plane,
                              damping, 0.5, augig_granite().rock, contact, 0, grains.fabric.phases);
            heated.go(20);
            return heated;
        };
        verify(name + "intact minerals heated and cooled", run(1000, 0, "300", straight).residual(), 0, 2e-5, source, 1);
        verify(name + "curved expansion, the temperature jumps", run(1000, 0, "300", curved).residual(), 0, 2e-5, source, 1);
        verify(name + "crystals with axes heated and cooled", run(1000, 0, "400", minerals_with_axes()).residual(), 0, 2e-5,
               source, 1);
        const ProgramRun cracked = run(1, 0.8, "\"keep\"", straight);
        EXPECT_GT(cracked.run.failed_points(), 100U);
        EXPECT_GT(cracked.energies.back().external, 1);  // what failures have taken is not given back
        verify(name + "minerals heated and cooled that crack", cracked.residual(), 0, 2e-3, source, 1);
    }
}

// The file has the temperature, the axes and the curves; threads and a checkpoint change nothing. Without temperature nothing
// expands, and where nothing expands a temperature is refused. A program that continues has no temperature of its own.
TEST(HeatedRun, KeepsItsTemperatureAndResumes) {
    const TemporaryFolder folder;
    Specimen specimen = minerals_with_axes().specimen;
    const std::vector<std::uint8_t>& phase = specimen.grain_phase;  // the last grain is of the crystal of another of its phase
    specimen.grain_crystal.resize(phase.size());
    std::iota(specimen.grain_crystal.begin(), specimen.grain_crystal.end(), 0);
    specimen.grain_crystal.back() =
        static_cast<std::int32_t>(std::find(phase.begin(), phase.end(), phase.back()) - phase.begin());
    SimulationRequest r;
    r.material = granite_of_phases();
    r.contact = augig_contact();
    r.loading.test = TestKind::program;
    r.save_state = true;
    const auto digest_of = [&](const std::string& name) {
        simulate(specimen, r, folder.file(name), Verbosity::quiet, {});
        return H5Input(folder.file(name), "run").digest();
    };
    const Program heat = parse_program(heat_and_cool("380"), "heat.toml");
    const Program rest =
        parse_program("name = \"rest\"\ndamping = 0.8\nstages = [\"rest\"]\nstage.rest.until.time = \"20 us\"", "");
    r.program = heat;
    EXPECT_THROW(digest_of("refused.h5"), InputError);
    r.program = rest;
    const std::string cold = digest_of("cold.h5");
    r.material.fabric.phases["quartz"].expansion_by_temperature = {{0, 480}, {7.7e-6, 12e-6}, {13.3e-6, 25e-6}};
    r.material.fabric.phases["mica"].thermal_expansion = 9e-6;
    r.material.fabric.young_modulus_by_temperature = {{0, 480}, {1, 0.8}, {}};
    EXPECT_EQ(digest_of("still-cold.h5"), cold);
    r.program = heat;
    const std::string whole = digest_of("whole.h5");
    const RunReader run(folder.file("whole.h5"));
    const std::vector<double> temperature = run.history()[HistoryColumn::temperature];
    EXPECT_TRUE(run.history().has_temperature);
    EXPECT_NEAR(*std::max_element(temperature.begin(), temperature.end()), 400, 1e-9);
    EXPECT_NEAR(temperature.back(), 0, 1e-9);
    EXPECT_EQ(run.file().read<double>(schema::grain_axis.path), crystal_axes(specimen));
    const std::vector<Phase> phases = run.header().fabric.phases;
    EXPECT_EQ(phases.front().across, (TemperatureCurve{{0, 13.3e-6}, {480, 25e-6}}));
    EXPECT_EQ(phases.front().softening, (TemperatureCurve{{0, 1}, {480, 0.8}}));
    EXPECT_EQ(phases.back().thermal_expansion, 9e-6);
    r.threads = 2;
    EXPECT_EQ(digest_of("threads.h5"), whole);
    r.stops_after = [stop = temperature.size() / 3](std::size_t rows) { return rows == stop; };
    EXPECT_THROW(digest_of("run.h5"), Interrupted);
    r.restart = checkpoint_of(folder.file("run.h5"));
    r.stops_after = nullptr;
    EXPECT_EQ(digest_of("run.h5"), whole);
    r.restart = folder.file("still-cold.h5");  // expands from there on
    EXPECT_NE(digest_of("continued.h5"), whole);
    r.program = rest;
    r.restart = folder.file("whole.h5");
    digest_of("after.h5");
    expect_golden(run.header().heat_label() + "\n" + RunReader(folder.file("after.h5")).header().heat_label());
}

/// A uniaxial test after heating. \param expansion of the quartz; the other minerals have `others`
SimulationRequest heated_test(double expansion, double others, double heat, bool cool) {
    SimulationRequest r;
    r.material = granite_of_phases();
    for (auto& [name, phase] : r.material.fabric.phases) phase.thermal_expansion = name == "quartz" ? expansion : others;
    r.contact = augig_contact();
    r.loading = {.rate = RateKind::automatic, .heat = heat, .cool = cool};
    r.mass_scaling = true;
    r.frames = 0;
    return r;
}

// The free specimen of one mineral expands without stress, whatever its shape becomes; platens wait for it. It
// is as strong as before, to the equilibrium of the automatic rate.
TEST(HeatedRun, LeavesTheStrengthOfOneMineral) {
    Specimen specimen = jittered_grid(6, 12, 0.03, 0.06, 0.25);
    const auto run = [&](double heat) {
        SimulationRequest r = heated_test(0, 0, heat, heat > 0);
        r.material.fabric.phases = {{"rock", {}}};
        r.material.fabric.phases["rock"].thermal_expansion = 8e-6;
        specimen.phase_names = {"rock"};
        return run_test(specimen, r, "", Verbosity::quiet);
    };
    const TestOutcome cold = run(0);
    const TestOutcome cooled = run(300);
    EXPECT_EQ(run(-100).header.heat_label(), "at -100 K");
    const History& h = cooled.history;
    const auto begin = static_cast<std::size_t>(
        std::find(h[HistoryColumn::time].begin(), h[HistoryColumn::time].end(), cooled.header.isotropic_end_time) -
        h[HistoryColumn::time].begin());
    ASSERT_LT(begin, h.size());
    EXPECT_EQ(h[HistoryColumn::temperature][begin], 0);
    EXPECT_EQ(failed_contacts(h)[begin], 0);
    EXPECT_EQ(*std::max_element(h[HistoryColumn::temperature].begin(), h[HistoryColumn::temperature].end()), 300);
    const double expanded = *std::max_element(h[HistoryColumn::gauge_axial_strain].begin(),
                                              h[HistoryColumn::gauge_axial_strain].begin() + static_cast<std::ptrdiff_t>(begin));
    verify("phases: strain of a free specimen that is heated before its test, largest", expanded, 1.23 * 8e-6 * 300, 1e-3,
           "(1 + ν) α T; waves");
    for (const HistoryColumn column :
         {HistoryColumn::gauge_axial_strain, HistoryColumn::lateral_strain, HistoryColumn::axial_stress})
        EXPECT_EQ(h[column][begin], 0);
    verify("phases: strength of one mineral heated and cooled over that before",
           cooled.header.peak_axial_stress / cold.header.peak_axial_stress, 1, 0.02, "equilibrium at the automatic rate");
}

// Stopped while it is heated, with its platens away, and while it is loaded.
TEST(HeatedRun, OfATestResumesByAnyNumberOfThreads) {
    const TemporaryFolder folder;
    const Specimen specimen = expanding_minerals().specimen;
    for (const TestKind kind : {TestKind::uniaxial, TestKind::tension}) {
        SimulationRequest r = heated_test(13e-6, 5e-6, 200, kind == TestKind::tension);
        r.loading.test = kind;
        r.loading.rate_tolerance = 0.05;  // for its time
        r.save_state = true;
        const std::string whole = folder.file("whole.h5");
        simulate(specimen, r, whole, Verbosity::quiet, {});
        const RunReader reader(whole);
        EXPECT_EQ(reader.header().heat, 200);
        EXPECT_EQ(reader.header().cooled, kind == TestKind::tension ? 1 : 0);
        const History history = reader.history();
        const auto heated =
            static_cast<std::size_t>(std::count_if(history[HistoryColumn::time].begin(), history[HistoryColumn::time].end(),
                                                   [&](double t) { return t < reader.header().isotropic_end_time; }));
        EXPECT_GT(failed_contacts(history)[heated], 0);
        double loaded = 0;  // stored energy beyond what heat left, to which the error of the balance is related
        const auto stored = [&](std::size_t row) {
            return history[HistoryColumn::energy_strain][row] + history[HistoryColumn::energy_contact][row];
        };
        for (std::size_t row = heated; row < history.size(); ++row) loaded = std::max(loaded, stored(row) - stored(heated));
        EXPECT_NEAR(reader.header().energy_scale, loaded, 1e-9 * stored(heated));
        r.threads = 2;
        for (const std::size_t stop : {heated / 2, heated + 40}) {
            const std::string run = folder.file("run.h5");
            r.restart.clear();
            r.stops_after = [stop](std::size_t rows) { return rows == stop; };
            EXPECT_THROW(simulate(specimen, r, run, Verbosity::quiet, {}), Interrupted);
            r.restart = checkpoint_of(run);
            r.stops_after = nullptr;
            simulate(specimen, r, run, Verbosity::quiet, {});
            EXPECT_EQ(H5Input(run, "run").digest(), H5Input(whole, "run").digest()) << stop;
        }
    }
}

}  // namespace
}  // namespace graincrack::test
