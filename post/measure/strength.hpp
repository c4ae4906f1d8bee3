// Strength of a test and what a reader needs to trust it: one row a run.
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "post/measure/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Strengths are positive; SI. Empty: the test does not measure it.
struct Strength {
    std::optional<double> peak_compressive_stress;  ///< uniaxial, triaxial: σ1 at the peak, confinement included
    std::optional<double> tensile_strength;         ///< brazilian: 2 Fmax/(π t D), Eq 18; tension: largest axial stress
    /// The one that the test measures.
    [[nodiscard]] double value() const { return peak_compressive_stress ? *peak_compressive_stress : tensile_strength.value(); }
    double strain_at_peak = 0;          ///< platen approach over height since the start of the test
    std::string peak_kind;              ///< see `peak_kind`
    std::optional<double> first_yield;  ///< see `first_yield`
    /// Stress where the platen strain first reaches `strain_marks`, whatever came before; empty if the test ended earlier.
    std::array<std::optional<double>, 3> stress_at_marks;
    double tensile_cracks = 0;  ///< contacts (points ÷ 2) failed by the time of the peak
    double shear_cracks = 0;
};

/// Axial strains at which the stress is told: strengths of tests that harden are compared at equal strain.
inline constexpr std::array<double, 3> strain_marks{0.01, 0.02, 0.03};

/// \throws InputError if the run has no usable curve
Strength measure_strength(const RunData& run);

/// What to do with a run that the strain cap ended: its largest stress is no peak, and a fit through such values depends on
/// where the tests were told to end.
enum class CappedRuns { refuse, accept };
/// Whether the run ended by the strain cap.
/// \param what needs a peak, with an article: "an envelope"
/// \throws InputError if it has no peak and may not stand here: a capped run unless accepted, a stopped one always
bool is_capped(const RunData& run, const Strength& strength, CappedRuns capped_runs, const std::string& what);

/// Writes the table `strength`, DESIGN's columns; all runs are measured before the first row is written.
void write_strength_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format);

}  // namespace graincrack
