// The constant-strain triangle: patch numbers, rigid rotation, forces as the gradient of the energy.
#include "solver/model/element.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

constexpr double young_modulus = 25.8e9;
constexpr double poisson_ratio = 0.23;
/// A triangle without symmetry, some millimetres across.
constexpr std::array<Vector2, 3> corners{{{0.001, 0.0005}, {0.0062, 0.0011}, {0.0029, 0.0048}}};

TriangleGeometry geometry() { return make_triangle_geometry(corners[0], corners[1], corners[2]); }
using Displacements = std::array<Vector2, 3>;
TriangleState state_of(const PlaneElasticity& c, const Displacements& u) {
    return triangle_state(geometry(), c, u[1] - u[0], u[2] - u[0]);
}
std::array<Vector2, 3> element_forces_of(const PlaneElasticity& c, const Displacements& u) {
    const TriangleForces f = triangle_forces(geometry(), state_of(c, u));
    return {f.on_node0(), f.on_node1, f.on_node2};
}
/// Displacements of x → R x + t.
Displacements rotation(double angle) {
    Displacements u;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector2 p = corners[k];
        u[k] = {std::cos(angle) * p.x - std::sin(angle) * p.y - p.x + 0.01, std::sin(angle) * p.x + std::cos(angle) * p.y - p.y};
    }
    return u;
}

// ε = (1e-4, −3e-5), γ = 5e-5, no rotation; seven digits by hand from Hooke's law.
TEST(Element, HasTheStressOfHookesLaw) {
    // Scaled down: the numbers are of small strains, the element's are of finite ones, which differ by the strain itself.
    const double scale = 1e-8;
    Displacements u;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector2 p = corners[k];
        u[k] = {scale * (1e-4 * p.x + 2.5e-5 * p.y), scale * (2.5e-5 * p.x - 3e-5 * p.y)};
    }
    const auto expect_stress = [&](PlaneCondition plane, const std::array<double, 4>& exact,
                                   const std::array<double, 4>& printed) {
        const PlaneElasticity c = make_plane_elasticity(young_modulus, poisson_ratio, plane);
        const std::array<double, 4> stress = triangle_stress(c, state_of(c, u));
        for (std::size_t i = 0; i < 4; ++i) {
            constexpr const char* component[] = {"xx", "yy", "xy", "zz"};
            const std::string name = "elements: CST patch, plane " + std::string(name_of(plane)) + ", " + component[i] + " (MPa)";
            verify(name, stress[i] / scale / MPa, exact[i] / MPa, 1e-10, "Hooke's law", exact[0] / MPa);
            expect_close(stress[i] / scale, printed[i] * MPa, 2e-7, 2.5 * MPa, "printed " + std::to_string(i));
        }
    };
    const double g = young_modulus / (2 * (1 + poisson_ratio));
    const double stress_factor = young_modulus / (1 - poisson_ratio * poisson_ratio);
    expect_stress(PlaneCondition::stress,
                  {stress_factor * (1e-4 - poisson_ratio * 3e-5), stress_factor * (-3e-5 + poisson_ratio * 1e-4), g * 5e-5, 0},
                  {2.536142, -0.190687, 0.524390, 0});
    const double strain_factor = young_modulus / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    const double xx = strain_factor * ((1 - poisson_ratio) * 1e-4 - poisson_ratio * 3e-5);
    const double yy = strain_factor * (-(1 - poisson_ratio) * 3e-5 + poisson_ratio * 1e-4);
    expect_stress(PlaneCondition::strain, {xx, yy, g * 5e-5, poisson_ratio * (xx + yy)},
                  {2.722945, -0.003884, 0.524390, 0.625384});
}

// Turned through 360°, the stress is none to 1e-9 of that of a strain of 1e-4, at which rock fails.
TEST(Element, HasNoStressFromRotation) {
    const PlaneElasticity c = make_plane_elasticity(young_modulus, poisson_ratio, PlaneCondition::strain);
    double farthest = 0;
    for (int degrees = 0; degrees <= 360; degrees += 5) {
        const Displacements u = rotation(degrees * std::numbers::pi / 180);
        farthest = std::max(farthest, length(u[1] - u[0]));
        for (const double s : triangle_stress(c, state_of(c, u))) {
            verify("elements: one CST through 360 deg, stress over E 1e-4", s, 0, 1e-9, "no stress from rotation",
                   young_modulus * 1e-4);
        }
    }
    EXPECT_GT(farthest, 0.01);  // twice the edge: it really turned
}

// A quarter turn exchanges xx and yy and the sign of xy; positions of order 1 lose 1e-16 each, over strains of 1e-4 1e-12.
TEST(Element, TurnsItsStressWithIt) {
    const PlaneElasticity c = make_plane_elasticity(young_modulus, poisson_ratio, PlaneCondition::stress);
    Displacements u;
    for (std::size_t k = 0; k < 3; ++k) u[k] = {1e-4 * corners[k].x, 0};
    const std::array<double, 4> before = triangle_stress(c, state_of(c, u));
    EXPECT_GT(before[0], 1 * MPa);
    Displacements turned;  // R (x + u) − x with R a quarter turn
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector2 now = corners[k] + u[k];
        turned[k] = Vector2{-now.y, now.x} - corners[k];
    }
    const std::array<double, 4> after = triangle_stress(c, state_of(c, turned));
    expect_close(after[1], before[0], 1e-10, before[0]);
    expect_close(after[0], before[1], 1e-10, before[0]);
    expect_close(after[2], -before[2], 1e-10, before[0]);
}

// Central differences of the energy, off by its round-off over h, 1e-16 · W/(f h) ≈ 1e-10; forces and moments sum up to none.
TEST(Element, HasTheForcesOfItsEnergyAtLargeRotation) {
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        const PlaneElasticity c = make_plane_elasticity(young_modulus, poisson_ratio, plane);
        for (const double angle : {0.0, 1.0, 2.5, -1.8}) {
            Displacements u = rotation(angle);
            u[1] += Vector2{2e-5, -1e-5};  // strains of half a per cent on top
            u[2] += Vector2{-1e-5, 3e-5};
            const auto energy = [&](std::size_t k, double dx, double dy) {
                Displacements v = u;
                v[k] += Vector2{dx, dy};
                return triangle_energy(geometry(), state_of(c, v));
            };
            const std::array<Vector2, 3> f = element_forces_of(c, u);
            const double scale = length(f[1]);
            EXPECT_GT(scale, 1e4);  // N: no empty comparison
            const double h = 1e-8;
            for (std::size_t k = 0; k < 3; ++k) {
                for (const auto& [slope, force] : {std::pair{(energy(k, h, 0) - energy(k, -h, 0)) / (2 * h), f[k].x},
                                                   std::pair{(energy(k, 0, h) - energy(k, 0, -h)) / (2 * h), f[k].y}}) {
                    verify("elements: CST force plus the slope of its energy, turned by up to 143 deg, over force", force, -slope,
                           1e-7, "central differences", scale);
                }
            }
            const Vector2 sum = f[0] + f[1] + f[2];
            expect_close(length(sum), 0, 1e-14, scale);
            double moment = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector2 now = corners[k] + u[k];
                moment += now.x * f[k].y - now.y * f[k].x;
            }
            expect_close(moment, 0, 1e-12, scale * 0.01);
        }
    }
}

}  // namespace
}  // namespace graincrack::test
