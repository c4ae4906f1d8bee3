// Hoek–Brown envelope of intact rock, fitted to strengths under confinement with GSL.
#pragma once

#include <optional>
#include <span>

namespace graincrack {

/// A value with its 95 % interval; the interval is empty where there are no degrees of freedom.
struct Estimate {
    double value = 0;
    std::optional<double> low;
    std::optional<double> high;
};

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

/// Student's t for a two-sided 95 % interval. \pre degrees_of_freedom ≥ 1
double student_t_95(int degrees_of_freedom);

}  // namespace graincrack
