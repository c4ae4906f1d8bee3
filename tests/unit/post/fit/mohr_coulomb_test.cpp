// The calibration arithmetic of Kazerani & Zhao (2014): Table 7 → C, φ → Eq 19 → contact cohesion and friction angle.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "post/fit/mohr_coulomb.hpp"
#include "share/base/error.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::verify;
constexpr double MPa = 1e6;
constexpr double degree = std::numbers::pi / 180;

struct DesignRun {
    double number, contact_cohesion, contact_friction_angle, cohesion, friction_angle;
    std::array<double, 3> strength;
    double x1, x2;
};

std::vector<DesignRun> table7() {
    std::ifstream file(GRAINCRACK_TEST_DATA "/table7.csv");
    std::string line;
    std::getline(file, line);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    EXPECT_EQ(line, "run,cc_MPa,phic_deg,C_MPa,phi_deg,s1_at_0,s1_at_4,s1_at_8,x1,x2");
    std::vector<DesignRun> runs;
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::array<double, 10> v{};
        for (double& value : v) {
            std::string cell;
            std::getline(cells, cell, ',');
            value = std::stod(cell);
        }
        runs.push_back({v[0], v[1], v[2], v[3], v[4], {v[5], v[6], v[7]}, v[8], v[9]});
        // the table prints √2 to five digits, the design uses the full value
        for (double* x : {&runs.back().x1, &runs.back().x2}) {
            if (std::abs(*x) > 1.4) *x = std::copysign(std::numbers::sqrt2, *x);
        }
    }
    EXPECT_EQ(runs.size(), 13U);
    return runs;
}

MohrCoulomb fit(const DesignRun& run) {
    const std::array<double, 3> confining{0, 4 * MPa, 8 * MPa};
    const std::array<double, 3> strength{run.strength[0] * MPa, run.strength[1] * MPa, run.strength[2] * MPa};
    return fit_mohr_coulomb(confining, strength);
}

double to_tenths(double value) { return std::round(value * 10) / 10; }

/// 1, x1, x2, x1 x2, x1², x2²: the terms of Eq 19.
using Terms = std::array<double, 6>;
Terms terms(double x1, double x2) { return {1, x1, x2, x1 * x2, x1 * x1, x2 * x2}; }
double value_at(const Terms& surface, double x1, double x2) {
    const Terms t = terms(x1, x2);
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += surface[i] * t[i];
    return sum;
}

/// Least squares by the normal equations and elimination with pivots.
Terms full_quadratic(const std::vector<DesignRun>& runs, const std::vector<double>& response) {
    std::array<std::array<double, 7>, 6> a{};
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const Terms t = terms(runs[r].x1, runs[r].x2);
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < 6; ++j) a[i][j] += t[i] * t[j];
            a[i][6] += t[i] * response[r];
        }
    }
    for (std::size_t k = 0; k < 6; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < 6; ++i) {
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        }
        std::swap(a[k], a[pivot]);
        for (std::size_t i = 0; i < 6; ++i) {
            if (i == k) continue;
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < 7; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    Terms surface{};
    for (std::size_t i = 0; i < 6; ++i) surface[i] = a[i][6] / a[i][i];
    return surface;
}

/// The root of C = 21 MPa, φ = 53° inside the design, by Newton's method from its centre.
std::array<double, 2> root(const Terms& cohesion, const Terms& friction) {
    double x1 = 0;
    double x2 = 0;
    for (int i = 0; i < 50; ++i) {
        const auto d1 = [&](const Terms& s) { return s[1] + s[3] * x2 + 2 * s[4] * x1; };
        const auto d2 = [&](const Terms& s) { return s[2] + s[3] * x1 + 2 * s[5] * x2; };
        const double f = value_at(cohesion, x1, x2) - 21;
        const double g = value_at(friction, x1, x2) - 53;
        const double det = d1(cohesion) * d2(friction) - d2(cohesion) * d1(friction);
        x1 -= (f * d2(friction) - g * d2(cohesion)) / det;
        x2 -= (g * d1(cohesion) - f * d1(friction)) / det;
    }
    return {x1, x2};
}

double contact_cohesion(double x1) { return 61.05 + 30.525 * x1; }     // MPa
double contact_friction_angle(double x2) { return 53.0 + 7.95 * x2; }  // deg

void expect_near(const std::string& name, const Terms& surface, const Terms& printed, double tolerance) {
    constexpr const char* term[] = {"1", "x1", "x2", "x1 x2", "x1^2", "x2^2"};
    for (std::size_t i = 0; i < 6; ++i) {
        verify("calibration: " + name + ", term " + term[i], surface[i], printed[i], tolerance, "Eq 19", 1);
    }
}

TEST(Calibration, StrengthsOfTable7GiveItsCohesionsAndFrictionAngles) {
    for (const DesignRun& run : table7()) {
        const MohrCoulomb envelope = fit(run);
        verify("calibration: Table 7, C of every run rounded (MPa)", to_tenths(envelope.cohesion / MPa), run.cohesion, 1e-15,
               "as printed, to 0.1");
        verify("calibration: Table 7, phi of every run rounded (deg)", to_tenths(envelope.friction_angle / degree),
               run.friction_angle, 1e-15, "as printed, to 0.1");
        EXPECT_GT(envelope.r_squared, 0.85);
        EXPECT_NEAR(envelope.intercept, 2 * envelope.cohesion * std::sqrt(envelope.slope), 1);
    }
}

TEST(Calibration, FactorsOfTable7) {
    for (const DesignRun& run : table7()) {
        EXPECT_NEAR(contact_cohesion(run.x1), run.contact_cohesion, 0.0051) << "run " << run.number;
        EXPECT_NEAR(contact_friction_angle(run.x2), run.contact_friction_angle, 0.0051) << "run " << run.number;
    }
}

TEST(Calibration, RoundedValuesGiveEquation19AndTheCalibratedContact) {
    const auto runs = table7();
    std::vector<double> cohesion;
    std::vector<double> friction;
    for (const DesignRun& run : runs) {
        cohesion.push_back(run.cohesion);
        friction.push_back(run.friction_angle);
    }
    const Terms c = full_quadratic(runs, cohesion);
    const Terms phi = full_quadratic(runs, friction);
    expect_near("C of rounded values", c, {11.12, 7.36, -4.94, -7.48, 1.32, 6.89}, 0.006);
    expect_near("phi of rounded values", phi, {66.98, -4.66, 15.76, 4.78, -0.60, -7.98}, 0.006);
    const auto x = root(c, phi);
    verify("calibration: root, x1", x[0], 0.443, 0.0005, "paper, three digits", 1);
    verify("calibration: root, x2", x[1], -0.533, 0.0005, "paper, three digits", 1);
    verify("calibration: contact cohesion (MPa)", contact_cohesion(x[0]), 74.57, 0.02, "paper", 1);
    verify("calibration: contact friction angle (deg)", contact_friction_angle(x[1]), 48.76, 0.01, "paper", 1);
}

TEST(Calibration, UnroundedValuesGiveNearlyTheSame) {
    const auto runs = table7();
    std::vector<double> cohesion;
    std::vector<double> friction;
    for (const DesignRun& run : runs) {
        cohesion.push_back(fit(run).cohesion / MPa);
        friction.push_back(fit(run).friction_angle / degree);
    }
    const Terms c = full_quadratic(runs, cohesion);
    const Terms phi = full_quadratic(runs, friction);
    expect_near("C of unrounded values", c, {11.098, 7.388, -4.938, -7.467, 1.322, 6.901}, 0.001);
    expect_near("phi of unrounded values", phi, {66.962, -4.654, 15.738, 4.785, -0.608, -7.955}, 0.001);
    const auto x = root(c, phi);
    verify("calibration: contact cohesion from unrounded values (MPa)", contact_cohesion(x[0]), 74.62, 0.01, "computed apart", 1);
    verify("calibration: contact friction angle from unrounded values (deg)", contact_friction_angle(x[1]), 48.77, 0.01,
           "computed apart", 1);
}

TEST(MohrCoulomb, ALineGivesItsOwnCohesionAndFriction) {
    const double C = 21 * MPa;
    const double phi = 53 * degree;
    const double b = (1 + std::sin(phi)) / (1 - std::sin(phi));
    const double a = 2 * C * std::sqrt(b);
    EXPECT_NEAR(a / MPa, 125.5, 0.05);  // not the 122 MPa of the laboratory: the three do not agree exactly
    const std::array<double, 4> confining{0, 2 * MPa, 2 * MPa, 9 * MPa};
    const std::array<double, 4> strength{a, a + b * 2 * MPa, a + b * 2 * MPa, a + b * 9 * MPa};
    const MohrCoulomb envelope = fit_mohr_coulomb(confining, strength);
    EXPECT_NEAR(envelope.cohesion / C, 1, 1e-12);
    EXPECT_NEAR(envelope.friction_angle / phi, 1, 1e-12);
    EXPECT_NEAR(envelope.r_squared, 1, 1e-12);
}

TEST(MohrCoulomb, WhatHasNoEnvelope) {
    const std::array<double, 2> same{4 * MPa, 4 * MPa};
    const std::array<double, 2> strength{100 * MPa, 110 * MPa};
    EXPECT_NEAR(mohr_coulomb_slope(std::asin(4.0 / 6)), 5, 1e-12);  // the line of tests/unit/post/summary/summarize_test.cpp
    EXPECT_EQ(mohr_coulomb_slope(0), 1);
    EXPECT_THROW(fit_mohr_coulomb(same, strength), InputError);
    EXPECT_THROW(fit_mohr_coulomb({}, {}), InputError);
    const std::array<double, 2> confining{0, 4 * MPa};
    EXPECT_THROW(fit_mohr_coulomb(confining, std::array<double, 2>{100 * MPa, std::nan("")}), InputError);
    EXPECT_THROW(fit_mohr_coulomb(confining, std::array<double, 1>{1}), std::invalid_argument);
    const MohrCoulomb falling = fit_mohr_coulomb(confining, std::array<double, 2>{100 * MPa, 90 * MPa});
    EXPECT_LT(falling.slope, 0);
    EXPECT_TRUE(std::isnan(falling.cohesion));
    EXPECT_TRUE(std::isnan(falling.friction_angle));
}

}  // namespace
}  // namespace graincrack
