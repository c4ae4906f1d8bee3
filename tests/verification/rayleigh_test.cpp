// Rayleigh waves: speed, and the ellipse of a point of the surface.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/program_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using std::numbers::pi;

/// The wave of a free surface of a half-space, with its wave number 1: u = (f(z) sin x, g(z) cos x) cos ct at the depth z
/// (Rayleigh 1885; Achenbach, Wave Propagation in Elastic Solids, §5.11).
struct RayleighWave {
    double shear = 0, longitudinal = 0;  ///< speeds of body waves, m/s
    double speed = 0;                    ///< m/s
    double q = 0, s = 0;                 ///< decay of the longitudinal and of the shear part

    RayleighWave(const Rock& granite, PlaneCondition condition) {
        const double nu = granite.poisson_ratio;
        const double modulus = condition == PlaneCondition::strain ? (1 - nu) / ((1 + nu) * (1 - 2 * nu)) : 1 / (1 - nu * nu);
        shear = std::sqrt(granite.young_modulus / (2 * (1 + nu) * granite.density));
        longitudinal = std::sqrt(granite.young_modulus * modulus / granite.density);
        // (2 − ξ²)² = 4 √(1 − ξ²) √(1 − ξ² cS²/cP²) for ξ = c/cS, by bisection
        double low = 0.5;
        double high = 1;
        while (high - low > 1e-14) {
            const double xi = 0.5 * (low + high);
            set(xi * shear);
            (std::pow(2 - xi * xi, 2) < 4 * q * s ? low : high) = xi;
        }
    }
    /// Amplitudes at a depth.
    [[nodiscard]] Vector2 at(double z) const {
        const double mixed = 2 * q / (1 + s * s);
        return {std::exp(-q * z) - mixed * s * std::exp(-s * z), mixed * std::exp(-s * z) - q * std::exp(-q * z)};
    }

private:
    void set(double c) {
        speed = c;
        q = std::sqrt(1 - c * c / (longitudinal * longitudinal));
        s = std::sqrt(1 - c * c / (shear * shear));
    }
};

// A standing wave in a strip of half a wavelength between smooth walls, three wavelengths deep, where a three hundredth of the
// motion is left. It starts with the velocities of the wave.
void expect_rayleigh(PlaneCondition condition, double ratio, const std::string& name_of_condition) {
    constexpr double strip_width = 0.05;
    constexpr double depth = 0.3;
    constexpr int cells = 20;
    constexpr int periods = 6;
    const Rock granite = augig_granite().rock;
    const RayleighWave wave(granite, condition);
    const double number = pi / strip_width;
    const double period = 2 * strip_width / wave.speed;
    ProgramRun strip(crossed_blocks(cells, 6 * cells, strip_width, depth, [](int, int) { return 0; }),
                     fmt::format(R"(
        name = "standing wave"
        stages = ["swing"]
        boundary.walls = {{ on = ["left", "right"], velocity_x = 0.0 }}
        boundary.deep = {{ on = "bottom", velocity_x = 0.0, velocity_y = 0.0 }}
        probe.edge.point = ["-24.999 mm", "149.999 mm"]
        probe.middle.point = [0, "149.999 mm"]
        stage.swing.until.time = {}
    )",
                                 periods * period),
                     augig_law(), condition, 0, 0.7);
    strip.run.set_velocity([&](const Vector2& p) {
        const double x = number * (p.x + strip_width / 2);
        const Vector2 amplitude = wave.at(number * (depth / 2 - p.y));
        return Vector2{amplitude.x * std::sin(x), amplitude.y * std::cos(x)};
    });
    strip.go(4);
    const std::vector<double>& time = strip[HistoryColumn::time];
    const std::vector<double>& along = strip.column("middle", "velocity_x");
    const std::vector<double>& across = strip.column("edge", "velocity_y");
    std::vector<double> zeros;
    double along_squared = 0, across_squared = 0;
    for (std::size_t i = 2; i < time.size(); ++i) {
        along_squared += along[i] * along[i];
        across_squared += across[i] * across[i];
        if (across[i - 1] * across[i] < 0) {
            zeros.push_back(time[i - 1] + (time[i] - time[i - 1]) * across[i - 1] / (across[i - 1] - across[i]));
        }
    }
    const double swing = 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
    const double speed = 2 * strip_width / swing;
    const std::string name = "dynamics: Rayleigh wave, " + name_of_condition + ", ";
    verify(name + "speed over that of S waves", speed / wave.shear, ratio, 1e-3, "Rayleigh's equation, four digits");
    verify(name + "motion along over across the surface", std::sqrt(along_squared / across_squared),
           std::abs(wave.at(0).x / wave.at(0).y), 5e-3, "its mode");
    record_curves(condition == PlaneCondition::strain ? "rayleigh-strain" : "rayleigh-stress",
                  {{"time_s", time}, {"velocity_x_m_s", along}, {"velocity_y_m_s", across}});
}
// The speed is the root of Rayleigh's equation, 0.9161 cS in plane strain and 0.9087 cS in plane stress, and a point of the
// surface moves as the mode has it; tolerances are those of 40 cells a wave, 2.3e-4 of the speed and 2.0e-3 of the ratio.
TEST(RayleighWave, HasItsSpeedAndItsMode) {
    expect_rayleigh(PlaneCondition::strain, 0.9161, "plane strain");
    expect_rayleigh(PlaneCondition::stress, 0.9087, "plane stress");
}

}  // namespace
}  // namespace graincrack::test
