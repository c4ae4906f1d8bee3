// Blocks that rest, slide and turn on each other.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "tests/support/small_run.hpp"

namespace graincrack::test {

inline constexpr double earth = 9.81;  ///< gravity, m/s²

/// Linear stiffnesses and friction; what is not broken from the start does not fail.
inline ContactLaw joint_law(double normal_stiffness, double shear_stiffness, double tan_friction) {
    ContactParameters contact = augig_contact();
    contact.tensile_strength = contact.cohesion = 1e12;
    contact.friction_angle = contact.residual_friction_angle = std::atan(tan_friction);
    contact.residual_cohesion = contact.residual_tensile_strength = 0;
    return with_stiffnesses(make_contact_law(contact, LawVariant::coulomb_slip), normal_stiffness, shear_stiffness);
}

/// A rectangle of nx × ny cells of four triangles, turned counter-clockwise about its lower right corner.
struct Block {
    int nx, ny;
    double left, bottom, width, height;
    double turn = 0;  ///< rad
};
/// Blocks without contacts, each a grain.
inline Specimen separate_blocks(const std::vector<Block>& blocks) {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    std::vector<int> grain;
    for (std::size_t r = 0; r < blocks.size(); ++r) {
        const Block& block = blocks[r];
        const int nx = block.nx;
        const int ny = block.ny;
        const auto add = [&](double x, double y) {  // from the lower right corner
            points.push_back({block.left + block.width + x * std::cos(block.turn) - y * std::sin(block.turn),
                              block.bottom + x * std::sin(block.turn) + y * std::cos(block.turn)});
        };
        const auto first = static_cast<int>(points.size());
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) add(block.width * (static_cast<double>(i) / nx - 1), block.height * j / ny);
        }
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const int a = first + j * (nx + 1) + i;
                const std::array<int, 4> corner{a, a + 1, a + nx + 2, a + nx + 1};
                const auto centre = static_cast<int>(points.size());
                add(block.width * ((i + 0.5) / nx - 1), block.height * (j + 0.5) / ny);
                for (std::size_t k = 0; k < 4; ++k) {
                    triangles.push_back({corner[k], corner[(k + 1) % 4], centre});
                    grain.push_back(static_cast<int>(r));
                }
            }
        }
    }
    return specimen_of_grains(points, triangles, grain);
}

/// Mean of a nodal field over a grain, by mass.
inline Vector2 mean_of_grain(const SmallRun& run, const std::vector<Vector2>& field, std::int32_t grain) {
    Vector2 sum;
    double mass = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
        if (run.assemblage.surface.grain_of_node[i] != grain) continue;
        sum += run.assemblage.mass[i] * field[i];
        mass += run.assemblage.mass[i];
    }
    return (1 / mass) * sum;
}

}  // namespace graincrack::test
