// Crystals that expand along their axis by another amount than across it: free, clamped, their axes, and the energy that they
// take.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "share/file/fabric.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/run/simulation.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/linear_statics.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::MPa;
using test::ProgramRun;
using test::SmallRun;
using test::verify;
using test::verify_between;

constexpr double heated_by = 100;  // K
constexpr double along_axis = 7.7e-6, across_axis = 13.3e-6;
const Phase crystal{60e9, 0.25, 2650, along_axis, {{0, along_axis}}, {{0, across_axis}}};

/// Grains of one crystal. \param seed by which its axis is drawn
SmallRun warm_crystal(PlaneCondition plane, std::uint64_t seed) {
    Specimen s = test::jittered_grid(3, 4, 0.02, 0.03, 0.25);
    s.grain_crystal.assign(s.n_grains(), 0);
    s.seed = seed;
    SmallRun run(std::move(s), {crystal}, ContactLaws(test::augig_law()), plane);
    test::warm(run.assemblage, heated_by, run.state);
    return run;
}

TEST(CrystalExpansion, AFreeCrystalExpandsWithoutStressAtAnyAngle) {
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            SmallRun run = warm_crystal(plane, seed);
            const double angle = crystal_axes(run.specimen).at(0);
            const double c = std::cos(angle), s = std::sin(angle);
            const double held = plane == PlaneCondition::strain ? crystal.poisson_ratio * across_axis : 0;
            const double xx = along_axis * c * c + across_axis * s * s + held,
                         yy = along_axis * s * s + across_axis * c * c + held;
            const double xy = (along_axis - across_axis) * c * s;
            for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
                const Vector2 x = run.assemblage.position[i];
                run.state.displacement[i] = {heated_by * (xx * x.x + xy * x.y), heated_by * (xy * x.x + yy * x.y)};
            }
            const double hindered = crystal.young_modulus * across_axis * heated_by;
            for (std::int32_t e = 0; e < run.assemblage.n_elements(); ++e) {
                std::array<double, 4> stress = element_stress(run.assemblage, e, run.state);
                if (plane == PlaneCondition::strain) stress[3] += hindered;  // across the plane, which does not strain
                for (const double of_nothing : stress) {
                    verify("phases: free crystal with an axis, stress over E α ΔT", of_nothing / hindered, 0, 1e-11,
                           "no stress in the plane", 1);
                }
            }
            run.begin();
            EXPECT_EQ(run.measured().energies.kinetic, 0);
            for (const Vector2& force : run.state.force) EXPECT_LT(length(force), 1e-12 * hindered);
        }
    }
}

// Clamped, λ = μ = 24 GPa: −(λ (a + 2 b) + 2 μ a) ΔT along the axis, −(λ (a + 2 b) + 2 μ b) ΔT across it; in plane stress with
// λ* = E ν/(1 − ν²) = 16 GPa and a + b. Turned by 30°.
TEST(CrystalExpansion, AClampedCrystalIsPressedByItsAxes) {
    const auto expect = [](PlaneCondition plane, const std::array<double, 4>& expected) {
        SmallRun run = warm_crystal(plane, 1);
        for (CrystalAxis& axis : run.assemblage.expansion.axis) axis = make_crystal_axis(std::numbers::pi / 6);
        const std::array<double, 4> stress = element_stress(run.assemblage, 7, run.state);
        for (std::size_t k = 0; k < 4; ++k) {
            verify("phases: clamped crystal, its axis at 30°, plane " + std::string(name_of(plane)) + " (MPa)", stress[k] / MPa,
                   expected[k], 1e-12, "Hooke's law of the free strain, turned", 100);
        }
    };
    expect(PlaneCondition::strain, {-126.0, -139.44, 13.44 * std::numbers::sqrt3 / 2, -146.16});
    expect(PlaneCondition::stress, {-77.28, -90.72, 13.44 * std::numbers::sqrt3 / 2, 0});
}

// χ² of 20 equal parts of [0, π), and the mean of exp 2iφ of crystals and of neighbours in number: four standard deviations of
// the mean of 10,000 uniform directions, √(1/2n) a component.
TEST(CrystalExpansion, AxesAreUniform) {
    constexpr std::size_t n = 10'000, parts = 20;
    Specimen s;
    s.grain_phase.assign(n, 0);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        s.seed = seed;
        const std::vector<double> angles = crystal_axes(s);
        ASSERT_EQ(angles.size(), n);
        std::array<double, parts> counts{};
        std::complex<double> mean, of_neighbours;
        for (std::size_t i = 0; i < n; ++i) {
            ++counts.at(static_cast<std::size_t>(parts * angles[i] / std::numbers::pi));
            mean += std::polar(1.0 / n, 2 * angles[i]);
            of_neighbours += std::polar(1.0 / n, 2 * (angles[i] - angles[(i + 1) % n]));
        }
        double chi_squared = 0;
        for (const double count : counts) chi_squared += (count - n / parts) * (count - n / parts) / (n / parts);
        verify_between("phases: χ² of the axes of crystals, 19 degrees of freedom", chi_squared, 5.41, 43.82, "0.1 and 99.9 %");
        for (const auto& sum : {mean, of_neighbours}) {
            verify("phases: mean direction of the axes of crystals", std::max(std::abs(sum.real()), std::abs(sum.imag())), 0,
                   4 / std::sqrt(2.0 * n), "none, to four standard deviations", 1);
        }
    }
    s.grain_crystal.assign(n, 0);
    s.grain_crystal.back() = 1;  // an axis a crystal, not a grain
    const std::vector<double> of_two = crystal_axes(s);
    EXPECT_TRUE(of_two[0] == of_two[n - 2] && of_two[0] != of_two[n - 1]);
}

// ∫α dT of 6e-6 at 0 and 14e-6 at 400 K, linear between and constant outside, and a modulus that falls to 0.6 on the way; clamped
// in plane stress, −f E ∫α dT/(1 − ν).
TEST(CrystalExpansion, ExpansionAndModulusChangeWithTemperature) {
    Phase changing = crystal;
    changing.along = changing.across = {{0, 6e-6}, {400, 14e-6}};
    changing.softening = {{0, 1}, {400, 0.6}};
    SmallRun run(test::jittered_grid(3, 4, 0.02, 0.03, 0.25), {changing}, ContactLaws(test::augig_law()), PlaneCondition::stress);
    for (const auto& [kelvin, expected] : {std::array{300.0, -151.2}, {450.0, -225.6}, {-100.0, 48.0}}) {
        test::warm(run.assemblage, kelvin, run.state);
        verify("phases: clamped mineral that changes with temperature (MPa)",
               element_stress(run.assemblage, 7, run.state)[0] / MPa, expected, 1e-12, "f E ∫α dT/(1 - ν)");
    }
}

/// Three minerals, two of whose crystals have axes, one of which changes with temperature; all soften.
test::PhasedSpecimen minerals_with_axes() {
    test::PhasedSpecimen varied = test::varied_phases(test::jittered_grid(8, 12, 0.02, 0.03, 0.25));
    varied.specimen.seed = 7;
    for (Phase& phase : varied.fabric.phases) phase.softening = {{0, 1}, {480, 0.7}};
    varied.fabric.phases[0].along = {{0, 7.7e-6}, {480, 12e-6}};
    varied.fabric.phases[0].across = {{0, 13.3e-6}, {480, 25e-6}};
    varied.fabric.phases[1].along = {{0, 15e-6}};
    varied.fabric.phases[1].across = {{0, 3e-6}};
    varied.fabric.phases[2].thermal_expansion = 9e-6;
    return varied;
}
const std::string heat_crystals = R"(name = "heat"
        stages = ["heat", "cool"]
        damping = 0.8
        stage.heat = { temperature = { to = "400 K", over = "0.2 ms" }, until = { time = "0.22 ms" } }
        stage.cool = { temperature = { to = 0, over = "0.2 ms" }, until = { time = "0.22 ms" } })";

// Intact and without damping, so that the balance is as close as the change of contacts' stiffness lets it.
TEST(CrystalExpansion, TheEnergyBalanceStaysClosed) {
    const test::PhasedSpecimen grains = minerals_with_axes();
    const ContactParameters contact = test::scaled_contact(test::augig_contact(), 1000);
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        ProgramRun heated(grains.specimen, heat_crystals, make_contact_law(contact, LawVariant::consistent), plane, 0, 0.5,
                          test::augig_granite().rock, contact, 0, grains.fabric.phases);
        heated.go(20);
        EXPECT_GT(heated.energies.back().kinetic, 0);
        verify("phases: residual of the energy balance over stored energy, crystals with axes heated and cooled",
               heated.residual(), 0, 2e-5, "each term by its own definition", 1);
    }
}

// The file tells the axes; threads and a checkpoint change nothing; without temperature it does not know that anything expands.
TEST(CrystalExpansion, ARunTellsItsAxesAndResumesWithThem) {
    const test::TemporaryFolder folder;
    Specimen specimen = minerals_with_axes().specimen;
    const std::vector<std::uint8_t>& phase = specimen.grain_phase;  // the last grain is of the crystal of another of its phase
    specimen.grain_crystal.resize(phase.size());
    std::iota(specimen.grain_crystal.begin(), specimen.grain_crystal.end(), 0);
    specimen.grain_crystal.back() =
        static_cast<std::int32_t>(std::find(phase.begin(), phase.end(), phase.back()) - phase.begin());
    SimulationRequest r;
    r.material = test::granite_of_phases();
    r.contact = test::augig_contact();
    r.loading.test = TestKind::program;
    r.save_state = true;
    r.program = parse_program(R"(name = "rest"
        stages = ["rest"]
        damping = 0.8
        stage.rest.until = { time = "0.02 ms" })",
                              "rest.toml");
    const auto digest_of = [&](const std::string& name) {
        simulate(specimen, r, folder.file(name), Verbosity::quiet, {});
        return H5Input(folder.file(name), "run").digest();
    };
    const std::string cold = digest_of("cold.h5");
    r.material.fabric.phases["quartz"].expansion_by_temperature = {{0, 480}, {along_axis, 12e-6}, {across_axis, 25e-6}};
    r.material.fabric.young_modulus_by_temperature = {{0, 480}, {1, 0.8}, {}};
    EXPECT_EQ(digest_of("still-cold.h5"), cold);
    r.program = parse_program(heat_crystals, "heat.toml");
    const std::string whole = digest_of("whole.h5");
    const H5Input file(folder.file("whole.h5"), "run");
    EXPECT_EQ(file.read<double>(schema::grain_axis.path), crystal_axes(specimen));
    const Phase quartz = read_header(file).fabric.phases.front();
    EXPECT_EQ(quartz.across, (TemperatureCurve{{0, across_axis}, {480, 25e-6}}));
    EXPECT_EQ(quartz.softening, (TemperatureCurve{{0, 1}, {480, 0.8}}));
    r.threads = 2;
    EXPECT_EQ(digest_of("threads.h5"), whole);
    r.stops_after = [](std::size_t rows) { return rows == 40; };
    EXPECT_THROW(digest_of("run.h5"), Interrupted);
    r.restart = checkpoint_of(folder.file("run.h5"));
    r.stops_after = nullptr;
    EXPECT_EQ(digest_of("run.h5"), whole);
    r.restart = folder.file("still-cold.h5");  // expands from there on
    EXPECT_NE(digest_of("continued.h5"), whole);
}

}  // namespace
}  // namespace graincrack
