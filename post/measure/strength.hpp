// Measures the strength of a test: its first peak, the residual strength after it, and the slope of re-hardening.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "post/run/load_curve.hpp"
#include "share/file/peak.hpp"

namespace graincrack {

/// The stress of a compression test that counts as its strength: the largest, that of the first peak, or the residual one.
enum class StrengthKind { largest, first_peak, residual };
/// The name in options and tables: "largest", "first-peak", "residual".
std::string name_of(StrengthKind kind);
/// The name in texts: "largest stress", "first peak", "residual strength".
std::string label_of(StrengthKind kind);
/// Text in place of the strength of a test without one; its largest stress may follow.
inline constexpr const char* did_not_fail = "did not fail";

/// Axial strains beyond the first peak, chosen by trial: ranges of residual strength and re-hardening, shortest range with a
/// slope.
inline constexpr double residual_strains[2] = {0.003, 0.005};
inline constexpr double rehardening_strains[2] = {0.005, 0.01};
inline constexpr double least_rehardening_strain = 0.001;

/// A first peak with the curve after it. Stresses are σ1 with the confining pressure, Pa, as the largest axial stress is.
struct FirstPeak : Peak {
    /// Mean over `residual_strains` beyond the first peak; empty if the test ends before.
    std::optional<double> residual;
    /// Fall from the first peak to the residual strength, as a fraction of σ1 − σ3 at the first peak; empty if `residual` is.
    std::optional<double> drop;
    /// Slope of σ1 − σ3 over `rehardening_strains` beyond the first peak, or over the part of them that the test reached, by
    /// least squares in which each strain counts equally, Pa. It is negative if the stress falls further, and empty if the test
    /// reached less than `least_rehardening_strain` of the range.
    std::optional<double> rehardening;
    /// `residual` if it is a strength after a fall; empty if the stress exceeds the first peak again.
    [[nodiscard]] std::optional<double> residual_strength() const {
        return residual && *residual < stress ? residual : std::nullopt;
    }
};

/// Measures a curve after its first peak.
FirstPeak with_residual(const Peak& peak, const CurveColumns& curve, double confining_pressure);

/// The first peak of a uniaxial or triaxial test that failed; empty for other tests.
std::optional<FirstPeak> measure_first_peak(const RunData& run, const LoadCurve& curve);

/// Values of the load curve at a row of the history; SI.
struct CurveRow {
    std::size_t row = 0;
    double stress = 0;
    double load = 0;            ///< N per metre of thickness
    double strain = 0;          ///< platen approach over height since the start of the test
    double tensile_cracks = 0;  ///< contacts (points ÷ 2) by then, as the history of the run counts them
    double shear_cracks = 0;
};

/// The strengths of a test, positive, SI. Values that the test does not measure are empty.
struct Strength {
    /// The strength that a laboratory reports (`find_strength`): σ1, 2 F/(π t D) for discs (Eq 18 of Kazerani & Zhao 2014), or
    /// the nominal stress in bending; empty for a test that did not fail.
    std::optional<double> strength;
    CurveRow peak;                        ///< row of `LoadCurve::peak`
    CurveRow largest;                     ///< row of the largest stress
    bool largest_is_peak = false;         ///< see `has_fallen`
    std::string peak_kind;                ///< see `peak_kind`
    std::optional<double> first_yield;    ///< see `first_yield`
    std::optional<FirstPeak> first_peak;  ///< uniaxial, triaxial
    /// Stress at which the platen strain first reaches `strain_marks`, before or after the peak; empty if the test ended earlier.
    std::array<std::optional<double>, 3> stress_at_marks;

    /// The strength of this kind. Tests without a residual strength, as tension, Brazilian tests and bending, have one kind only.
    [[nodiscard]] std::optional<double> reported(StrengthKind kind = StrengthKind::first_peak) const;
    /// True if this strength is a peak, after which the stress fell.
    [[nodiscard]] bool has_peak(StrengthKind kind = StrengthKind::first_peak) const {
        return kind == StrengthKind::largest ? largest_is_peak : strength.has_value();
    }
    /// The row of the strength of this kind.
    [[nodiscard]] const CurveRow& at(StrengthKind kind) const { return kind == StrengthKind::largest ? largest : peak; }
};

/// Axial strains at which the stress is reported, so that tests that harden are compared at equal strain.
inline constexpr std::array<double, 3> strain_marks{0.01, 0.02, 0.03};

Strength measure_strength(const RunData& run, const LoadCurve& curve);
/// Measures the strengths of a run. \throws InputError if the run has no usable curve
inline Strength measure_strength(const RunData& run) { return measure_strength(run, load_curve(run)); }

/// Treatment of runs stopped at the strain limit whose largest stress is no peak. A fit through such values depends on the strain
/// limit that was chosen.
enum class StrainLimitRuns { refuse, accept };
/// True if a run was stopped at the strain limit and its largest stress is no peak.
/// \param what the result that requires a peak, with an article: "an envelope"
/// \throws InputError if the largest stress is no peak and the run was stopped otherwise, or such runs are refused
bool stopped_at_strain_limit(const RunData& run, const Strength& strength, StrainLimitRuns strain_limit_runs,
                             const std::string& what);

}  // namespace graincrack
