// Hoek–Brown envelope of intact rock, fitted to strengths under confinement with GSL.
#pragma once

#include <optional>
#include <span>

#include "post/statistics.hpp"

namespace graincrack {

/// σ1 = σ3 + σci (mi σ3/σci + 1)^½ (s = 1, a = ½).
struct HoekBrown {
    Estimate sigma_ci;  ///< Pa
    Estimate mi;
};

/// Non-linear least squares in σ1 (Levenberg–Marquardt); intervals from the covariance at the optimum and Student's t.
///
/// \param confining σ3, Pa \param strength peak σ1, Pa; equally long
/// \return empty if there are fewer than two confining pressures, or if no σci > 0 fits
std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength);

}  // namespace graincrack
