// Minerals that expand by different amounts, where the answer is known: free, clamped, in laminates, around an inclusion; and the
// energy that temperature brings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
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

constexpr double warmer = 100;  // K
const Phase mineral{60e9, 0.25, 2600, 8e-6};
/// Hooke's stress of strain that cannot happen, E α ΔT.
const double hindered = mineral.young_modulus * mineral.thermal_expansion * warmer;

SmallRun warm_run(PlaneCondition plane) {
    SmallRun run(test::jittered_grid(4, 5, 0.02, 0.03, 0.25), {mineral}, ContactLaws(test::augig_law()), plane);
    test::warm(run.assemblage, warmer, run.state);
    return run;
}

TEST(Temperature, OneMineralThatIsFreeExpandsWithoutStress) {
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        SmallRun run = warm_run(plane);
        const bool is_strain = plane == PlaneCondition::strain;
        const double strain = (is_strain ? 1 + mineral.poisson_ratio : 1) * mineral.thermal_expansion * warmer;
        for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
            run.state.displacement[i] = strain * run.assemblage.position[i];
        }
        for (std::int32_t e = 0; e < run.assemblage.n_elements(); ++e) {
            std::array<double, 4> stress = element_stress(run.assemblage, e, run.state);
            if (is_strain) stress[3] += hindered;  // across the plane, which does not strain
            for (const double of_nothing : stress) {
                verify("phases: free mineral, stress over E α ΔT", of_nothing / hindered, 0, 1e-11, "no stress in the plane", 1);
            }
        }
        run.begin();
        EXPECT_EQ(run.measured().energies.kinetic, 0);
        for (const Vector2& force : run.state.force) EXPECT_LT(length(force), 1e-12 * hindered);
    }
}

TEST(Temperature, OneMineralThatIsClampedIsPressed) {
    const SmallRun strain = warm_run(PlaneCondition::strain);
    const SmallRun stress = warm_run(PlaneCondition::stress);
    for (const std::size_t k : {0, 1, 3}) {
        verify("phases: clamped mineral in plane strain (MPa)", element_stress(strain.assemblage, 7, strain.state)[k] / MPa, -96,
               1e-12, "E α ΔT/(1 - 2 ν)");
        verify("phases: clamped mineral in plane stress (MPa)", element_stress(stress.assemblage, 7, stress.state)[k] / MPa,
               k == 3 ? 0 : -64, 1e-12, "E α ΔT/(1 - ν)", 64);
    }
}

/// Rings of triangles around the origin: one grain of `n_inner` rings up to radius 1, one outside of it.
Specimen inclusion(int around, int n_inner, int n_outer) {
    std::vector<test::Point> points{{0, 0}};
    std::vector<test::Triangle> triangles;
    std::vector<int> grain;
    const auto node = [&](int ring, int k) { return ring == 0 ? 0 : 1 + (ring - 1) * around + k % around; };
    for (int ring = 1; ring <= n_inner + n_outer; ++ring) {
        const double growth = 1 + 2 * std::numbers::pi / around;  // as long as wide
        const double r = ring <= n_inner ? static_cast<double>(ring) / n_inner : std::pow(growth, ring - n_inner);
        const bool is_outer = ring > n_inner;
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            points.push_back({r * std::cos(angle), r * std::sin(angle)});
            triangles.push_back({node(ring - 1, k), node(ring, k), node(ring, k + 1)});
            if (ring > 1) triangles.push_back({node(ring - 1, k), node(ring, k + 1), node(ring - 1, k + 1)});
            grain.resize(triangles.size(), is_outer ? 1 : 0);
        }
    }
    Specimen s = test::specimen_of_grains(points, triangles, grain);
    s.phase_names = {"quartz", "feldspar"};
    s.grain_phase = {0, 1};
    return s;
}

// Pressure of a round inclusion in a plane without end; that the outer radius is 36 takes 0.1 % of it.
TEST(Temperature, ARoundGrainOfQuartzIsPressedByFeldspar) {
    const std::vector<Phase> phases{{83.1e9, 0.17, 2650, 13e-6}, {60e9, 0.32, 2600, 6e-6}};
    constexpr double little = 1e-6;  // K, so that displacements are small
    for (const auto& [plane, expected] : {std::pair(PlaneCondition::stress, 21.88), {PlaneCondition::strain, 23.30}}) {
        SmallRun run(inclusion(128, 12, 75), phases, test::same_of_every_class(test::joint_law(6e15, 6e15, 0), 2), plane);
        const Eigen::VectorXd u = test::equilibrium(run, test::tangent_stiffness(run), test::load_of_temperature(run, little));
        for (std::int32_t i = 0; i < run.assemblage.n_nodes(); ++i) run.state.displacement[i] = test::displacement_of(u, i);
        test::warm(run.assemblage, little, run.state);
        const auto stress = element_stress(run.assemblage, 0, run.state);
        verify("phases: round quartz in feldspar, plane " + std::string(name_of(plane)) + " (MPa per 100 K)",
               -0.5 * (stress[0] + stress[1]) * (warmer / little) / MPa, expected, 2e-3,
               "Lamé in an endless plane; 128 edges around");
    }
}

// A bar of two minerals that is held at both ends and cooled until it breaks.
TEST(Temperature, AClampedPairOfMineralsOpens) {
    constexpr double half = 0.05;  // m
    const std::vector<Phase> phases{{60e9, 0, 2600, 7e-6}, {83.1e9, 0, 2650, 7e-6}};
    Specimen s = test::crossed_blocks(10, 1, 2 * half, 0.01, [](int i, int) { return i / 5; });
    s.phase_names = {"feldspar", "quartz"};
    s.grain_phase = {0, 1};
    const ContactParameters contact = test::augig_contact(PlaneCondition::stress);
    ProgramRun pair(std::move(s), R"(
        name = "cool"
        stages = ["cool"]
        [boundary.ends]
        on = ["left", "right"]
        velocity_x = 0
        [stage.cool]
        temperature = { times = [0, "20 ms"], values = [0, "-100 K"] }
        until = { time = "20 ms", tensile_cracks = 1 })",
                    make_contact_law(contact, LawVariant::consistent), PlaneCondition::stress, 0.8, 0.5,
                    test::augig_granite().rock, contact, 0, phases);
    pair.go(20);
    ASSERT_EQ(pair.stage_controller.records().front().ended_by, "tensile_cracks");
    const double strength = contact.tensile_strength;
    const double gives_way =
        strength * half * (1 / phases[0].young_modulus + 1 / phases[1].young_modulus) + contact.critical_opening;
    verify("phases: clamped pair of minerals, temperature at which it opens (K)", pair[HistoryColumn::temperature].back(),
           -gives_way / (half * (phases[0].thermal_expansion + phases[1].thermal_expansion)), 2e-3,
           "tc on its bars and its contact; waves of the cooling");
}

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
test::PhasedSpecimen expanding_minerals() {
    test::PhasedSpecimen varied = test::varied_phases(test::jittered_grid(8, 12, 0.02, 0.03, 0.25));
    for (std::size_t p = 0; p < 3; ++p) varied.fabric.phases[p].thermal_expansion = 12e-6 - 5e-6 * static_cast<double>(p);
    return varied;
}

// Without failures to the change of contacts' stiffness, also where the temperature jumps; with failures as for other loads.
TEST(Temperature, TheEnergyBalanceStaysClosed) {
    const test::PhasedSpecimen grains = expanding_minerals();
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        const auto run = [&](double strength, double damping, const char* middle) {
            const ContactParameters contact = test::scaled_contact(test::augig_contact(), strength);
            ProgramRun heated(grains.specimen, heat_and_cool(middle), make_contact_law(contact, LawVariant::consistent), plane,
                              damping, 0.5, test::augig_granite().rock, contact, 0, grains.fabric.phases);
            heated.go(20);
            return heated;
        };
        verify("phases: residual of the energy balance over stored energy, intact minerals heated and cooled",
               run(1000, 0, "300").residual(), 0, 2e-5, "each term by its own definition", 1);
        const ProgramRun cracked = run(1, 0.8, "\"keep\"");
        EXPECT_GT(cracked.run.failed_points(), 100U);
        EXPECT_GT(cracked.energies.back().external, 1);  // what failures have taken is not given back
        verify("phases: residual of the energy balance over stored energy, minerals heated and cooled that crack",
               cracked.residual(), 0, 2e-3, "each term by its own definition", 1);
    }
}

// The temperature is written, resumed from a checkpoint and refused where nothing expands.
TEST(Temperature, ARunHasItAndResumesWithIt) {
    const test::TemporaryFolder folder;
    const Specimen specimen = expanding_minerals().specimen;
    SimulationRequest r;
    r.material = test::granite_of_phases();
    r.contact = test::augig_contact();
    r.loading.test = TestKind::program;
    r.program = parse_program(heat_and_cool("380"), "heat.toml");
    r.save_state = true;
    EXPECT_THROW(simulate(specimen, r, folder.file("cold.h5"), Verbosity::quiet, {}), InputError);
    r.material.fabric.phases["quartz"].thermal_expansion = 13e-6;
    simulate(specimen, r, folder.file("whole.h5"), Verbosity::quiet, {});
    const RunReader whole(folder.file("whole.h5"));
    const History history = whole.history();
    EXPECT_TRUE(history.has_temperature);
    const std::vector<double>& temperature = history[HistoryColumn::temperature];
    EXPECT_NEAR(*std::max_element(temperature.begin(), temperature.end()), 400, 1e-9);
    EXPECT_NEAR(temperature.back(), 0, 1e-9);
    EXPECT_EQ(whole.header().fabric.phases.front().thermal_expansion, 13e-6);
    const std::string run = folder.file("run.h5");
    r.stops_after = [stop = history.size() / 3](std::size_t rows) { return rows == stop; };
    EXPECT_THROW(simulate(specimen, r, run, Verbosity::quiet, {}), Interrupted);
    r.restart = checkpoint_of(run);
    r.stops_after = nullptr;
    simulate(specimen, r, run, Verbosity::quiet, {});
    EXPECT_EQ(H5Input(run, "run").digest(), H5Input(folder.file("whole.h5"), "run").digest());
}

}  // namespace
}  // namespace graincrack
