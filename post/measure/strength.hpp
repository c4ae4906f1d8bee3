// Strength of a test with the checks of its run: one row a run.
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "post/measure/first_peak.hpp"
#include "post/run/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Which stress of a compression test is its strength: the largest, that of the first peak, or the residual one.
enum class StrengthKind { largest, first_peak, residual };
/// "largest", "first-peak", "residual": as options and tables name it.
std::string name_of(StrengthKind kind);
/// "largest stress", "first peak", "residual strength"
std::string label_of(StrengthKind kind);
/// Stands for the strength of a test without one, beside which its largest stress may be told.
inline constexpr const char* did_not_fail = "did not fail";

/// Strengths are positive; SI. Empty: the test does not measure it.
struct Strength {
    std::optional<double> peak_compressive_stress;  ///< uniaxial, triaxial: σ1 at the peak, confinement included
    std::optional<double> tensile_strength;         ///< brazilian: 2 Fmax/(π t D), Eq 18; tension: axial stress; if it failed
    std::optional<double> flexural_strength;        ///< bending of a beam without cracks that failed: the nominal bending stress
    double peak_stress =
        0;                 ///< largest stress of the load curve, in bending the nominal one; of the other tests one of the above
    double peak_load = 0;  ///< largest load, N per metre of thickness
    [[nodiscard]] double value() const { return peak_stress; }
    /// The same by another definition; empty if the test has no such strength, as tension, Brazilian tests and bending for all
    /// but the largest.
    [[nodiscard]] std::optional<double> value(StrengthKind kind) const;
    /// True if the stress exceeds its first peak later.
    [[nodiscard]] bool has_earlier_peak() const { return first_peak && first_peak->strain < strain_at_peak - smoothing_strain; }
    /// The strength as a laboratory reports it, see `find_strength`; empty for a test that did not fail. \param kind `largest`:
    /// the largest stress of all tests
    [[nodiscard]] std::optional<double> reported(StrengthKind kind = StrengthKind::first_peak) const {
        if (kind == StrengthKind::largest) return peak_stress;
        if (first_peak) return first_peak->stress;
        return peak_kind == "drop" ? std::optional(peak_stress) : std::nullopt;
    }
    /// True if that is a peak: the stress fell behind it.
    [[nodiscard]] bool has_peak(StrengthKind kind = StrengthKind::first_peak) const {
        return peak_kind == "drop" || (first_peak && kind != StrengthKind::largest);
    }
    double strain_at_peak = 0;            ///< platen approach over height since the start of the test
    std::string peak_kind;                ///< see `peak_kind`
    std::optional<double> first_yield;    ///< see `first_yield`
    std::optional<FirstPeak> first_peak;  ///< uniaxial, triaxial
    std::size_t row = 0;                  ///< of the history: of the strength, or of the largest stress if it did not fail
    /// Stress where the platen strain first reaches `strain_marks`, before or after the peak; empty if the test ended earlier.
    std::array<std::optional<double>, 3> stress_at_marks;
    double tensile_cracks = 0;  ///< contacts (points ÷ 2) by the time of the peak, as the history of the run counts them
    double shear_cracks = 0;
};

/// Axial strains at which the stress is reported: strengths of tests that harden are compared at equal strain.
inline constexpr std::array<double, 3> strain_marks{0.01, 0.02, 0.03};

/// \throws InputError if the run has no usable curve
Strength measure_strength(const RunData& run);

/// The treatment of a run stopped at the strain limit: its largest stress is no peak, and a fit through such values depends on
/// the strain limit that was chosen.
enum class StrainLimitRuns { refuse, accept };
/// True if the run was stopped at the strain limit.
/// \param what requires a peak, with an article: "an envelope"
/// \throws InputError if the run has no peak and is not accepted without one: stopped at the strain limit unless
///         accepted, stopped otherwise always
bool stopped_at_strain_limit(const RunData& run, const Strength& strength, StrainLimitRuns strain_limit_runs,
                             const std::string& what);

/// Writes the table `strength`, whose columns are those of share/doc/tables.md; all runs are measured before the first row is
/// written. \param kind of the strengths for the terminal: first peaks of compression tests, or the largest stress of all
/// \param diagnostics gets, after the table, a line for each
/// reason to doubt the strength of a run, and one if direct tension is stronger than the Brazilian test
void write_strength_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, std::ostream& diagnostics,
                          StrengthKind kind = StrengthKind::first_peak, ColumnChoice columns = ColumnChoice::all);

}  // namespace graincrack
