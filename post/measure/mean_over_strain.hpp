// Means of a measured curve over axial strain, in which each strain counts equally however densely rows of the history lie.
#pragma once

#include <span>
#include <vector>

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

}  // namespace graincrack
