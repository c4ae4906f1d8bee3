// Kazerani & Zhao (2014), Tables 3, 4 and 9 and the numbers of their text, to the digits printed.
#include "share/rock/fracture_process_zone.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "share/base/units.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using std::numbers::e;
using enum PlaneCondition;

const Rock augig{25.8e9, 0.23, 2650, 1.5e6, 3.0e6, 8.8e6};
constexpr double MPa = 1e6;
constexpr double mm = 1e-3;
constexpr double MPa_per_mm = 1e9;

double rounded(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
}

TEST(FractureProcessZone, GivesTheStiffnessesOfTable3) {
    EXPECT_EQ(format_number(fpz::normal_stiffness(augig, stress) / MPa_per_mm, 3), "6.51e+05");
    EXPECT_EQ(format_number(fpz::normal_stiffness(augig, strain) / MPa_per_mm, 3), "6.87e+05");
    EXPECT_EQ(format_number(fpz::shear_stiffness(augig, stress) / MPa_per_mm, 3), "6.61e+04");
    EXPECT_EQ(format_number(fpz::shear_stiffness(augig, strain) / MPa_per_mm, 3), "6.98e+04");
    // ks/kt = (K_IC/K_IIC)² / (2 (1 + ν)), in both planes
    for (const auto plane : {stress, strain}) {
        EXPECT_NEAR(fpz::shear_stiffness(augig, plane) / fpz::normal_stiffness(augig, plane), 0.25 / 2.46, 1e-12);
        EXPECT_NEAR(fpz::mode_ii_zone_thickness(augig, plane) / fpz::mode_i_zone_thickness(augig, plane), 4, 1e-12);
    }
}

TEST(FractureProcessZone, GivesFractureEnergies) {
    EXPECT_EQ(rounded(fpz::mixed_mode_fracture_energy(augig, stress), 1), 436.0);
    EXPECT_EQ(rounded(fpz::mixed_mode_fracture_energy(augig, strain), 1), 413.0);
    EXPECT_EQ(rounded(fpz::mode_i_fracture_energy(augig, stress), 1), 87.2);
    EXPECT_EQ(rounded(fpz::mode_i_fracture_energy(augig, strain), 1), 82.6);
    EXPECT_NEAR(fpz::mixed_mode_fracture_energy(augig, strain), 412.97965, 5e-6);
}

TEST(FractureProcessZone, GivesTheUltimateDisplacementsOfTable4) {
    struct Row {
        double tensile_strength, plane_strain, plane_stress;
    };
    for (const Row row : {Row{8.8, 0.094, 0.099}, {17.6, 0.047, 0.050}, {26.4, 0.031, 0.033}, {35.2, 0.023, 0.025}}) {
        for (const auto plane : {strain, stress}) {
            const double opening = fpz::critical_displacement(row.tensile_strength * MPa, fpz::normal_stiffness(augig, plane));
            const double ultimate =
                fpz::ultimate_displacement(fpz::mixed_mode_fracture_energy(augig, plane), row.tensile_strength * MPa, opening);
            EXPECT_EQ(rounded(ultimate / mm, 3), plane == strain ? row.plane_strain : row.plane_stress) << row.tensile_strength;
        }
    }
}

TEST(FractureProcessZone, HasItsEnergyAsTheAreaUnderTheOpeningCurve) {
    const double kt = fpz::normal_stiffness(augig, strain);
    const double tc = 24.15 * MPa;
    const double Gf = fpz::mixed_mode_fracture_energy(augig, strain);
    const double dct = fpz::critical_displacement(tc, kt);
    const double dut = fpz::ultimate_displacement(Gf, tc, dct);
    EXPECT_NEAR(kt * dct * std::exp(-1.0), tc, 1e-6 * tc);  // Eq 7 peaks at tc

    // Simpson's rule over the elastic branch, Eq 7; the softening branch is a triangle, Eq 9
    const auto traction = [&](double d) { return kt * d * std::exp(-d / dct); };
    const int n = 1000;
    double elastic = traction(0) + traction(dct);
    for (int i = 1; i < n; ++i) elastic += (i % 2 == 1 ? 4 : 2) * traction(i * dct / n);
    elastic *= dct / n / 3;
    EXPECT_NEAR(elastic, tc * dct * (e - 2), 1e-10 * elastic);
    EXPECT_NEAR(elastic + tc * (dut - dct) / 2, Gf, 1e-9 * Gf);
    EXPECT_NEAR(elastic / Gf, 0.0040, 5e-5);
}

TEST(FractureProcessZone, GivesTheSlidingAtThePeak) {
    const double dcs = fpz::critical_displacement(74.57 * MPa, fpz::shear_stiffness(augig, strain));
    EXPECT_NEAR(dcs / mm, 2.9025e-3, 5e-8);
    EXPECT_NEAR(74.57 * MPa * dcs * (e - 2), 155.46, 5e-3);  // energy to the peak
}

TEST(FractureProcessZone, GivesGrainSizesZonesAndStrengths) {
    EXPECT_EQ(rounded(fpz::min_grain_size(augig) / mm, 1), 0.4);
    EXPECT_EQ(rounded(fpz::max_grain_size(augig) / mm, 1), 8.6);
    EXPECT_EQ(rounded(fpz::min_grain_size_shear(augig) / mm, 2), 1.59);
    EXPECT_NEAR(fpz::zone_length(augig), 3 * fpz::max_grain_size(augig), 1e-15);
    EXPECT_NEAR(fpz::min_grain_size(augig), 10 * fpz::mode_i_zone_thickness(augig, stress), 1e-15);
    for (const auto plane : {strain, stress}) {  // Ẽ Gf is a toughness squared: the same in both planes
        const double mixed = fpz::mixed_mode_fracture_energy(augig, plane);
        const double mode_i = fpz::mode_i_fracture_energy(augig, plane);
        EXPECT_EQ(rounded(fpz::contact_zone_length(augig, plane, mixed, 24.15 * MPa) / mm, 1), 17.0);
        EXPECT_EQ(rounded(fpz::contact_zone_length(augig, plane, mode_i, 24.15 * MPa) / mm, 1), 3.4);
    }
    EXPECT_EQ(rounded(fpz::contact_tensile_strength_from_toughness(1.5e6, 4.0 * mm) / MPa, 1), 26.8);
    EXPECT_EQ(rounded(fpz::contact_tensile_strength_from_toughness(1.5e6, 5.13 * mm) / MPa, 1), 23.6);
    EXPECT_EQ(rounded(fpz::tensile_strength_from_toughness(1.5e6) / MPa, 1), 10.3);
}

TEST(FractureProcessZone, GivesTable9) {
    constexpr std::array<std::array<double, 6>, 5> table{{{0.30, 0.29, 0.28, 0.27, 0.26, 0.26},
                                                          {0.28, 0.27, 0.26, 0.25, 0.25, 0.24},
                                                          {0.26, 0.25, 0.24, 0.24, 0.23, 0.22},
                                                          {0.25, 0.24, 0.23, 0.22, 0.22, 0.21},
                                                          {0.24, 0.23, 0.22, 0.21, 0.21, 0.20}}};
    for (int m = 8; m <= 12; ++m) {
        for (int n = 13; n <= 18; ++n) {
            const double b = fpz::lennard_jones_b(m, n);
            test::verify("calibration: Table 9, worst of b(m, n) rounded", rounded(b, 2),
                         table[static_cast<std::size_t>(m - 8)][static_cast<std::size_t>(n - 13)], 1e-15, "Table 9");
            const double q = (m + 1.0) / (n + 1.0);  // an equivalent form of Eq 31
            EXPECT_NEAR(b, (1.0 / m - 1.0 / n) / (std::pow(q, (m + 1.0) / (n - m)) - std::pow(q, (n + 1.0) / (n - m))), 1e-14);
        }
    }
    // half of the last digit
    test::verify("calibration: b(8, 13)", fpz::lennard_jones_b(8, 13), 0.298187, 5e-7, "Eq 31", 1);
    test::verify("calibration: b(10, 15)", fpz::lennard_jones_b(10, 15), 0.243237, 5e-7, "Eq 31", 1);
    test::verify("calibration: b(12, 18)", fpz::lennard_jones_b(12, 18), 0.200165, 5e-7, "Eq 31", 1);
}

TEST(FractureProcessZone, GivesEnergyOverStrengthAndLengthOfThePotential) {
    // energy to separate from rest over (largest force × rest distance): b = Gf/(σt w), Eqs 23–30 with w the rest distance
    const int m = 10;
    const int n = 15;
    const double rest = std::pow(static_cast<double>(n) / m, 1.0 / (n - m));  // minimum of the potential, in ζ
    const double depth = -fpz::lennard_jones_potential(rest, m, n);
    EXPECT_NEAR(depth, 1, 1e-12);  // a makes the well X deep
    double force = 0;
    const double h = 1e-5;
    for (double z = rest; z < 2 * rest; z += 1e-4) {
        const double slope = (fpz::lennard_jones_potential(z + h, m, n) - fpz::lennard_jones_potential(z - h, m, n)) / (2 * h);
        force = std::max(force, slope);
    }
    EXPECT_NEAR(depth / (force * rest), fpz::lennard_jones_b(m, n), 1e-6);
    EXPECT_NEAR(fpz::zone_thickness(400, 0.25, 8e6), 2e-4, 1e-18);
}

TEST(FractureProcessZone, GivesModuliOfAssemblages) {
    const double kn = fpz::normal_stiffness(augig, stress);
    const double ks = fpz::shear_stiffness(augig, stress);
    const double Sv = 2 * std::sqrt(3.0) / (5.13 * mm);
    const auto soft = fpz::assemblage_moduli(augig, stress, kn, ks, Sv);
    EXPECT_NEAR(1 / soft.young_modulus, 1 / 25.8e9 + Sv * (3 / (8 * kn) + 1 / (8 * ks)), 1e-22);
    EXPECT_NEAR(soft.poisson_ratio, (0.23 / 25.8e9 - Sv / 8 * (1 / kn - 1 / ks)) * soft.young_modulus, 1e-12);
    EXPECT_EQ(soft.plane_young_modulus, soft.young_modulus);
    EXPECT_NEAR(soft.young_modulus / 1e9, 24.6, 0.3);  // random meshes of this size: 24.5 to 24.8
    EXPECT_NEAR(soft.poisson_ratio, 0.25, 0.01);

    for (const auto plane : {stress, strain}) {  // no compliance: the rock itself
        const auto stiff = fpz::assemblage_moduli(augig, plane, 1e30, 1e30, Sv);
        EXPECT_NEAR(stiff.young_modulus / 25.8e9, 1, 1e-12);
        EXPECT_NEAR(stiff.poisson_ratio, 0.23, 1e-12);
    }
    const auto deep =
        fpz::assemblage_moduli(augig, strain, fpz::normal_stiffness(augig, strain), fpz::shear_stiffness(augig, strain), Sv);
    EXPECT_NEAR(deep.young_modulus / 1e9, 24.7, 0.3);
    EXPECT_NEAR(deep.poisson_ratio, 0.24, 0.005);
    EXPECT_GT(deep.plane_young_modulus, deep.young_modulus);
    EXPECT_GT(deep.plane_poisson_ratio, deep.poisson_ratio);
}

TEST(FractureProcessZone, AddsAShareOfTheComplianceAndLeavesThePoissonRatio) {
    constexpr double share = 0.01;
    constexpr double length_per_area = 700;  // 1/m
    for (const auto plane : {PlaneCondition::stress, PlaneCondition::strain}) {
        const fpz::ContactStiffness stiff = fpz::stiffness_of_added_compliance(augig, plane, share, length_per_area);
        const auto body = fpz::assemblage_moduli(augig, plane, stiff.normal, stiff.shear, length_per_area);
        const double alone = fpz::effective_modulus(augig, plane);
        EXPECT_NEAR(alone / body.plane_young_modulus, 1 + share, 1e-12);
        EXPECT_NEAR(body.poisson_ratio, augig.poisson_ratio, 1e-12);
    }
}

TEST(FractureProcessZone, ConvertsModuliOfPlaneStrain) {
    const double nu = 0.23;
    EXPECT_NEAR(fpz::material_poisson_ratio(nu / (1 - nu)), nu, 1e-15);
    EXPECT_NEAR(fpz::material_young_modulus(25.8e9 / (1 - nu * nu), nu / (1 - nu)), 25.8e9, 1e-4);
}

}  // namespace
}  // namespace graincrack
