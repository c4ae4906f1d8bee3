// Bars of rock without Poisson effect, so that one dimension is exact: interfaces at equal distances, and a collision.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/linear_statics.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using std::numbers::pi;

Rock rock_without_poisson_effect() {
    Rock rock = augig_granite().rock;
    rock.poisson_ratio = 0;
    return rock;
}
const double bar_modulus = rock_without_poisson_effect().young_modulus;
const double density = rock_without_poisson_effect().density;
const double bar_speed = std::sqrt(bar_modulus / density);

// --- interfaces every s ------------------------------------------------------------------------------------------------

constexpr int segments = 20;
constexpr int cells_of_segment = 8;  // of a segment: a wave of two segments is resolved by 16, off by 0.2 %
constexpr double spacing = 0.01;
constexpr double cell_height = spacing / cells_of_segment;
const double interface_stiffness = 10 * bar_modulus / spacing;  // of the interfaces, Pa/m

SmallRun bar_with_interfaces(double fraction = 0.5) {
    return {crossed_blocks(segments * cells_of_segment, 1, segments * spacing, cell_height,
                           [](int i, int) { return i / cells_of_segment; }),
            with_stiffnesses(augig_law(), interface_stiffness, interface_stiffness / 10), PlaneCondition::stress, fraction,
            rock_without_poisson_effect()};
}

// Strain between nodes ten segments apart under a stress, by linear algebra: 1/E' = 1/E + 1/(k s), to its round-off.
TEST(Bar, HasTheModulusOfItsInterfaces) {
    const SmallRun run = bar_with_interfaces();
    const double stress = 1e6;
    const Eigen::VectorXd u = equilibrium(run, tangent_stiffness(run), boundary_load(run, {stress, 0, 0}));
    const auto at = [&](int segment) {
        const std::size_t element = 4 * static_cast<std::size_t>(cells_of_segment) * static_cast<std::size_t>(segment);
        return displacement_of(u, run.assemblage.node_of_specimen[run.specimen.element_nodes[element][0]]);
    };
    const double strain = (at(14).x - at(4).x) / (10 * spacing);
    const double expected = 1 / (1 / bar_modulus + 1 / (interface_stiffness * spacing));
    EXPECT_LT(expected, 0.95 * bar_modulus);
    verify("elements: bar with interfaces, modulus (GPa)", stress / strain * 1e-9, expected * 1e-9, 1e-9, "1/E + 1/(k s)");
}

/// Angular frequency of the free bar's standing wave with `half_waves` half waves, from the zeros of its amplitude.
double measured_frequency(int half_waves, int periods) {
    SmallRun run = bar_with_interfaces();
    const double length = segments * spacing;
    const double q = half_waves * pi / length;
    const auto shape = [&](const Vector2& p) { return std::cos(q * (p.x + length / 2)); };
    run.set_velocity([&](const Vector2& p) { return Vector2{1e-9 * shape(p), 0}; });  // openings 1e-9 of the critical one
    run.begin();
    const auto amplitude = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < run.state.velocity.size(); ++i) {
            sum += run.assemblage.mass[i] * run.state.velocity[i].x * shape(run.assemblage.position[i]);
        }
        return sum;
    };
    double before = amplitude();
    double first = 0;
    for (int zeros = 0;;) {
        run.steps(1);
        const double now = amplitude();
        if ((now > 0) != (before > 0)) {
            const double time = run.state.time - run.parameters.time_step * now / (now - before);
            if (zeros == 0) {
                first = time;
            } else if (zeros == 2 * periods) {
                return 2 * pi * periods / (time - first);
            }
            ++zeros;
        }
        before = now;
    }
}

/// Lowest ω of cos(q s) = cos(ω s/c) − (ω Z/2k) sin(ω s/c), Z = ρ c, by bisection.
double bloch_frequency(double q) {
    const auto excess = [q](double omega) {
        const double x = omega * spacing / bar_speed;
        return std::cos(x) - omega * density * bar_speed / (2 * interface_stiffness) * std::sin(x) - std::cos(q * spacing);
    };
    double low = 0;
    double high = pi * bar_speed / spacing;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (excess(middle) > 0 ? low : high) = middle;
    }
    return low;
}

// Frequencies of standing waves: long ones have the speed √(E'/ρ), 0.953463 c0 at k s/E = 10, others those of Bloch's condition
// (`bloch_frequency`), to 0.5 %: 16 cells resolve the shortest to 0.2 %.
TEST(Bar, DispersesWavesByItsInterfaces) {
    const double speed = std::sqrt(1 / (1 / bar_modulus + 1 / (interface_stiffness * spacing)) / density);
    EXPECT_NEAR(speed / bar_speed, 0.953463, 5e-7);
    verify("dynamics: bar with interfaces, speed of long waves over c0",
           measured_frequency(1, 8) * segments * spacing / pi / bar_speed, 0.953463, 5e-3, "sqrt(E_eff/rho)/c0 at k s/E = 10");
    for (const int half_waves : {5, 10, 15, 19}) {
        const double q = half_waves * pi / (segments * spacing);
        const double omega = bloch_frequency(q);
        verify("dynamics: bar with interfaces, frequency at q s = " + std::to_string(half_waves) + "/20 pi over c0/s",
               measured_frequency(half_waves, 40) * spacing / bar_speed, omega * spacing / bar_speed, 5e-3, "Bloch");
        // The waves are dispersed: the long waves' speed would be seen to be wrong.
        EXPECT_TRUE(half_waves < 19 || omega < 0.985 * speed * q);
    }
}

// --- two equal bars collide --------------------------------------------------------------------------------------------

// One flies against the other at rest: they touch for 2 L/c0 under ρ c0 v/2, then the first rests and the second flies.
TEST(Bar, ExchangesItsVelocityWithAnEqualBar) {
    constexpr int n = 200;  // cells of a bar
    const double length = 0.1;
    Specimen specimen = crossed_blocks(2 * n, 2, 2 * length, 2 * length / n, [](int i, int) { return i < n ? 0 : 1; });
    break_contacts(specimen, [](double, double) { return true; });
    ASSERT_EQ(specimen.n_contacts(), 2U);
    SmallRun run(specimen, augig_law(), PlaneCondition::stress, 0.5, rock_without_poisson_effect());
    const double v = 0.1;
    const auto is_first = [&](std::size_t node) { return run.assemblage.surface.grain_of_node[node] == 0; };
    for (std::size_t i = 0; i < run.state.velocity.size(); ++i) run.state.velocity[i] = {is_first(i) ? v : 0, 0};
    run.begin();
    const double expected_stress = density * bar_speed * v / 2;
    const double expected_time = 2 * length / bar_speed;
    const auto contact_stress = [&] {
        double sum = 0;
        for (std::size_t point = 0; point < 4; ++point) {
            sum -= run.parameters.laws[0].kt * std::min(0.0, run.state.opening[point]) / 4;
        }
        return sum;
    };
    double begin = 0, end = 0, mean = 0;
    int samples = 0;
    const auto steps = static_cast<int>(1.5 * expected_time / run.parameters.time_step);
    for (int i = 0; i < steps; ++i) {
        run.steps(1);
        const double stress = contact_stress();
        if (stress > 0.5 * expected_stress) {
            begin = begin == 0 ? run.state.time : begin;
            end = run.state.time;
        }
        if (run.state.time > 0.1 * expected_time && run.state.time < 0.9 * expected_time) {
            mean += stress;
            ++samples;
        }
    }
    double first = 0, second = 0;
    for (std::size_t i = 0; i < run.state.velocity.size(); ++i) {
        (is_first(i) ? first : second) += run.assemblage.mass[i] * run.state.velocity[i].x / (run.mass() / 2);
    }
    EXPECT_EQ(contact_stress(), 0);  // they have parted
    // Fronts of 200 cells are about (1/200)^(2/3) of the bar wide: 3 %; their middle is met to a tenth of that.
    verify("dynamics: two equal bars, contact time (s)", end - begin, expected_time, 5e-3, "2 L/c0");
    verify("dynamics: two equal bars, stress (MPa)", mean / samples * 1e-6, expected_stress * 1e-6, 5e-3, "rho c0 v/2");
    verify("dynamics: two equal bars, speed of the second after (m/s)", second, v, 5e-3, "velocities exchanged");
    verify("dynamics: two equal bars, speed of the first after over v", first, 0, 5e-3, "velocities exchanged", v);
}

}  // namespace
}  // namespace graincrack::test
