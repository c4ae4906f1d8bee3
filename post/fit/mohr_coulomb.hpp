// Computes cohesion and friction angle of a rock from its strengths under confinement.
#pragma once

#include <optional>
#include <span>

#include "post/statistics/statistics.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// A straight Mohr–Coulomb envelope σ1 = intercept + slope σ3 fitted to peak strengths, positive in compression.
struct MohrCoulomb : Line {
    double cohesion = 0;        ///< C = a / (2 √b), Pa; NaN if b ≤ 0
    double friction_angle = 0;  ///< φ with sin φ = (b − 1)/(b + 1), rad; NaN if b ≤ 0, negative if b < 1
};

/// Returns the slope b = (1 + sin φ)/(1 − sin φ) of the line σ1 = 2C√b + b σ3. \param friction_angle φ, rad
double mohr_coulomb_slope(double friction_angle);

/// Returns φ of a line of slope b, rad; −90° if b ≤ 0.
double friction_angle_of(double slope);

/// Returns b of the line σ1 = UCS + b σ3 of [laboratory], from its friction angle, or else its confined strength, or else its
/// cohesion; empty without these. \throws InputError if the confined strength is not above the uniaxial one
std::optional<double> laboratory_slope(const Material& material);

/// Fits σ1 = a + b σ3 by least squares and computes C and φ of the line, as Kazerani & Zhao (2014) §4.2 do for Table 7.
///
/// \param confining σ3 of each test, Pa \param strength peak σ1 of each test, Pa; equally long
/// \throws InputError unless there are strengths at two or more confining pressures, all finite
MohrCoulomb fit_mohr_coulomb(std::span<const double> confining, std::span<const double> strength);

}  // namespace graincrack
