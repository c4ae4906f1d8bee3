// The strength of a compression test as a laboratory reports it: the first peak, the residual strength behind it, and how the
// stress rises again. Means over axial strain, in which each strain counts equally however densely rows of the history lie.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "post/run/load_curve.hpp"

namespace graincrack {

/// A curve that is straight between its rows. Rows whose strain does not exceed that of all rows before are left out: where the
/// platens stop or retreat, the first value at a strain is that of the curve.
class MeanOverStrain {
public:
    /// \param strain, value of the rows; equally many, at least one
    MeanOverStrain(std::span<const double> strain, std::span<const double> value);

    [[nodiscard]] double first_strain() const { return strain_.front(); }
    [[nodiscard]] double last_strain() const { return strain_.back(); }
    /// Mean between two strains, or over that part of them which the curve has; the value of the curve if they are equal.
    /// \pre from ≤ to, and the curve has a strain between them
    [[nodiscard]] double mean(double from, double to) const;
    /// Mean over the window of this width with the strain at its centre. Near the ends of the curve the window is narrower on
    /// both sides, so that a straight curve stays as it is and the last value is that of the last row.
    [[nodiscard]] double moving_mean(double strain, double width) const;

private:
    struct Place {
        double value = 0;     ///< of the curve
        double integral = 0;  ///< of the curve, from its first strain
    };
    [[nodiscard]] Place at(double strain) const;

    std::vector<double> strain_;
    std::vector<double> value_;
    std::vector<double> integral_;  ///< from the first row to each
};

/// The moving mean at the strain of each row.
std::vector<double> moving_mean(std::span<const double> strain, std::span<const double> value, double width);

/// Width of the moving mean over axial strain by which the curve is smoothed before a peak is sought.
inline constexpr double smoothing_strain = 5e-5;
/// A maximum P of σ1 − σ3 is the first peak if the stress falls below this share of P before it exceeds P.
inline constexpr double first_peak_fall_to = 1 - peak_fall;
/// Axial strains beyond the first peak: of the residual strength, of re-hardening, and the least of the latter that has a slope.
inline constexpr double residual_strains[2] = {0.003, 0.005};
inline constexpr double rehardening_strains[2] = {0.005, 0.01};
inline constexpr double least_rehardening_strain = 0.001;

/// Stresses are σ1, confinement included, so that they compare with the largest axial stress; Pa.
struct FirstPeak {
    double strain = 0;  ///< platen approach over height
    double stress = 0;  ///< of the smoothed curve
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

/// The first maximum of the smoothed curve, since contacts have failed, that the stress falls behind. Falls before any contact
/// has failed are waves or play of the control.
///
/// \param failed number of failed contacts \param confining_pressure σ3, Pa; the columns are equally long
/// \return empty if the stress never falls enough behind a maximum
std::optional<FirstPeak> measure_first_peak(std::span<const double> axial_strain, std::span<const double> axial_stress,
                                            std::span<const double> failed, double confining_pressure);

/// The same of a uniaxial or triaxial test; empty for other tests.
std::optional<FirstPeak> measure_first_peak(const RunData& run, const LoadCurve& curve);

}  // namespace graincrack
