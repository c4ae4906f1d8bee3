// The peak at which a test has its strength, by the columns of its load curve. Means over axial strain, in which each strain
// counts equally however densely rows of the history lie.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "share/file/history.hpp"
#include "share/file/run_header.hpp"

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

/// Width of the moving mean over axial strain by which the curve is smoothed before a first peak is sought.
inline constexpr double smoothing_strain = 5e-5;
/// The fall behind a maximum, as a share of σ1 − σ3 there, that makes it a peak.
inline constexpr double peak_fall = 0.05;

/// Axial stress up to which a specimen that heat has cracked may settle between platens, of the tensile strength.
inline constexpr double settling_load = 0.3;
/// While the cracks of such a specimen close and its rough faces settle, the stress falls by up to a quarter and rises far beyond
/// again, within a fifth more of strain (measured from 250 K and after 180 K, temperature.md). So its peak has at least this
/// share of the largest stress of the curve;
inline constexpr double heated_peak = 0.5;
/// it falls by as much;
inline constexpr double heated_fall = 0.3;
/// and a drop ends a stage once the strain is so many times that at the highest stress.
inline constexpr double heated_strain = 1.25;

/// Rows of a load curve, positive in the sense of the test, from the start of axial loading on; equally long.
struct CurveColumns {
    std::span<const double> strain;
    std::span<const double> stress;  ///< Pa
    std::span<const double> failed;  ///< number of failed contacts
};

/// Tensile and shear ones of each row.
std::vector<double> failed_contacts(const History& history);

/// A maximum of a load curve.
struct Peak {
    std::size_t row = 0;  ///< of the largest stress of the curve within `smoothing_strain` of the maximum
    double strain = 0;    ///< of the maximum, which is of the smoothed curve where that was searched
    double stress = 0;    ///< likewise, Pa, confinement included
};

/// What is a peak of a load curve.
struct PeakRule {
    double fall = peak_fall;  ///< behind it, of σ1 − σ3 there
    double least_load = 0;    ///< of σ1 − σ3 from which on there is a load, Pa
    double share = 0;         ///< of the largest σ1 − σ3 that it has at least
};
/// That of a test: of a heated one by the numbers above. \param header with heat and rock
PeakRule peak_rule(const RunSettings& header);

/// The first maximum of the smoothed curve, since contacts have failed, that σ1 − σ3 falls behind before it exceeds it, under
/// loading: where the platens retreat the stress falls without failure. Falls before any contact has failed are waves or play of
/// the control. Empty if there is none. \param confining_pressure σ3, Pa
std::optional<Peak> find_first_peak(const CurveColumns& curve, double confining_pressure, const PeakRule& rule = {});

/// True if the largest stress is a peak: the test ended by its fall, or contacts failed and σ1 − σ3 fell as the rule
/// says at a larger strain.
bool has_fallen(const RunHeader& header, const CurveColumns& curve);

/// The strength of a test, and its row. In compression the first peak; also the largest stress if its fall ended the test and
/// smoothing hides it. In other tests the largest stress. Empty for a test that did not fail.
std::optional<Peak> find_strength(const RunHeader& header, const CurveColumns& curve);

/// The same of a history, whose row it has. \param sense −1 if the test compresses, else 1
std::optional<Peak> find_strength(const RunHeader& header, const History& history, double sense);

}  // namespace graincrack
