// Hoek–Brown envelope of intact rock, fitted to strengths under confinement with GSL.
#pragma once

#include <optional>
#include <span>

#include "post/statistics/statistics.hpp"

namespace graincrack {

/// σ1 = σ3 + σci (mi σ3/σci + 1)^½ (s = 1, a = ½).
struct HoekBrown {
    Estimate sigma_ci;  ///< Pa
    Estimate mi;
    /// σ1 at σ3, Pa; NaN where the envelope ends in tension.
    [[nodiscard]] double strength(double confining) const;
    /// The σ3 at which σ1 = 0, positive: σci (√(mi² + 4) − mi)/2, Pa.
    [[nodiscard]] double tensile_strength() const;
};

/// Non-linear least squares in σ1; intervals from the covariance at the optimum and Student's t.
///
/// \param confining σ3, Pa \param strength peak σ1, Pa; equally long
/// \return empty if there are fewer than two confining pressures, or if no σci > 0 fits
std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength);

/// The same with tensile strengths (Pa, positive) as points of the envelope at σ1 = 0. Residuals are relative: that of a
/// tensile strength counts as much as that of a strength many times as large.
std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength,
                                        std::span<const double> tensile);

}  // namespace graincrack
