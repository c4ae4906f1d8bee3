// Finds the peak that is the strength of a test in the columns of its load curve. Curves are smoothed by means over axial strain,
// in which each strain counts equally however dense the rows of the history are.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "share/file/history.hpp"
#include "share/file/run_header.hpp"

namespace graincrack {

/// A curve that is linear between its rows. Rows whose strain does not exceed that of all earlier rows are left out: where the
/// platens stop or retreat, the first value at a strain counts.
class MeanOverStrain {
public:
    /// \param strain, value columns of equal length, with at least one row
    MeanOverStrain(std::span<const double> strain, std::span<const double> value);

    [[nodiscard]] double first_strain() const { return strain_.front(); }
    [[nodiscard]] double last_strain() const { return strain_.back(); }
    /// Mean over the part of the curve between two strains; the value of the curve if they are equal.
    /// \pre from ≤ to, and the curve has a strain between them
    [[nodiscard]] double mean(double from, double to) const;
    /// Mean over a window of this width, centred at the strain. Near the ends of the curve the window is narrower on both sides,
    /// so that a straight curve does not change and the last value is that of the last row.
    [[nodiscard]] double moving_mean(double strain, double width) const;

private:
    struct Place {
        double value = 0;     ///< of the curve
        double integral = 0;  ///< of the curve, from its first strain
    };
    [[nodiscard]] Place at(double strain) const;

    std::vector<double> strain_;
    std::vector<double> value_;
    std::vector<double> integral_;  ///< from the first row to each row
};

/// The moving mean at the strain of each row, in O(n log n) for n rows.
std::vector<double> moving_mean(std::span<const double> strain, std::span<const double> value, double width);

/// Width, in axial strain, of the moving mean that smooths a curve before a first peak is sought. Chosen by trial; not varied
/// since. It lowers a sharp peak by up to 1 %.
inline constexpr double smoothing_strain = 5e-5;
/// Fall behind a maximum, as a fraction of σ1 − σ3 there, that makes it a peak. Chosen by trial; not varied since.
inline constexpr double peak_fall = 0.05;

/// Axial stress, over the tensile strength, up to which a heated specimen may settle between platens. Chosen by trial; not varied
/// since.
inline constexpr double settling_load = 0.3;
/// While the cracks of a heated specimen close and its rough faces settle, the stress falls and then rises beyond its former
/// value. Measured: a fall of 23 % that was exceeded within 1.21 times the strain (100 crystals at 250 K, temperature.md). The
/// next three numbers lie beyond that. The peak of a heated test has at least this fraction of the largest stress of the curve.
inline constexpr double heated_peak = 0.5;
/// Fall behind a maximum, as a fraction of σ1 − σ3 there, that makes it a peak of a heated test.
inline constexpr double heated_fall = 0.3;
/// A drop ends a stage of a heated test once the strain is so many times that at the highest stress.
inline constexpr double heated_strain = 1.25;

/// Columns of equal length of a load curve from the start of axial loading on, positive in the sense of the test.
struct CurveColumns {
    std::span<const double> strain;
    std::span<const double> stress;  ///< Pa
    std::span<const double> failed;  ///< number of failed contacts
};

/// Number of contacts that have failed in tension or shear, row by row.
std::vector<double> failed_contacts(const History& history);

/// A maximum of a load curve.
struct Peak {
    std::size_t row = 0;  ///< of the largest stress of the curve within `smoothing_strain` of the maximum
    double strain = 0;    ///< of the maximum; a first peak is a maximum of the smoothed curve
    double stress = 0;    ///< of the same maximum, with the confining pressure, Pa
};

/// The conditions for a peak of a load curve.
struct PeakRule {
    double fall = peak_fall;  ///< fall behind it, as a fraction of σ1 − σ3 there
    double least_load = 0;    ///< smallest σ1 − σ3 that counts as a load, Pa
    double share = 0;         ///< smallest fraction of the largest σ1 − σ3
};
/// The rule for a test; a heated test has the numbers above. \param header with heat and rock
PeakRule peak_rule(const RunSettings& header);

/// Finds the first maximum of the smoothed σ1 − σ3, after contacts have failed, behind which σ1 − σ3 falls as the rule says
/// before it exceeds the maximum. Rows in which the platens retreat do not count, as the stress then falls without failure; falls
/// before the first failure come from waves or the control. \param confining_pressure σ3, Pa \return empty if there is none
std::optional<Peak> find_first_peak(const CurveColumns& curve, double confining_pressure, const PeakRule& rule = {});

/// True if the largest stress is a peak: its fall ended the test, or contacts failed and σ1 − σ3 fell as the rule says at a
/// larger strain.
bool has_fallen(const RunHeader& header, const CurveColumns& curve);

/// Returns the strength of a test with its row: in compression the first peak or, if smoothing hides a peak whose fall ended the
/// test, the largest stress; in other tests the largest stress. Empty for a test that did not fail.
std::optional<Peak> find_strength(const RunHeader& header, const CurveColumns& curve);

/// The same from a history, with the row of the history. \param sense −1 if the test compresses, else 1
std::optional<Peak> find_strength(const RunHeader& header, const History& history, double sense);

}  // namespace graincrack
