// The first peak of a compression test, the residual strength behind it, and how the stress rises again.
#pragma once

#include <optional>

#include "post/run/load_curve.hpp"
#include "share/file/peak.hpp"

namespace graincrack {

/// Axial strains beyond the first peak: of the residual strength, of re-hardening, and the least of the latter that has a slope.
inline constexpr double residual_strains[2] = {0.003, 0.005};
inline constexpr double rehardening_strains[2] = {0.005, 0.01};
inline constexpr double least_rehardening_strain = 0.001;

/// Stresses are σ1, confinement included, so that they compare with the largest axial stress; Pa.
struct FirstPeak : Peak {
    /// Mean over `residual_strains` beyond the first peak; empty if the test ends before.
    std::optional<double> residual;
    /// Fall from the first peak to the residual strength, as a share of σ1 − σ3 at the first peak; empty without a residual
    /// strength.
    std::optional<double> drop;
    /// Slope of σ1 − σ3 over `rehardening_strains` beyond the first peak, or over the part of them that the test reached, by
    /// least squares in which each strain counts equally; negative where the stress falls further; empty if it reached less than
    /// `least_rehardening_strain` of them.
    std::optional<double> rehardening;
    /// `residual` where it is a strength left behind a fall: empty where the stress is above the first peak again.
    [[nodiscard]] std::optional<double> residual_strength() const {
        return residual && *residual < stress ? residual : std::nullopt;
    }
};

/// What a curve has behind its first peak.
FirstPeak with_residual(const Peak& peak, const CurveColumns& curve, double confining_pressure);

/// That of a uniaxial or triaxial test that failed; empty for others.
std::optional<FirstPeak> measure_first_peak(const RunData& run, const LoadCurve& curve);

}  // namespace graincrack
