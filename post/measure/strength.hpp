// Strength of a test: the first peak, the residual strength behind it, and how the stress rises again.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "post/run/load_curve.hpp"
#include "share/file/peak.hpp"

namespace graincrack {

/// Which stress of a compression test is its strength: the largest, that of the first peak, or the residual one.
enum class StrengthKind { largest, first_peak, residual };
/// "largest", "first-peak", "residual": as options and tables name it.
std::string name_of(StrengthKind kind);
/// "largest stress", "first peak", "residual strength"
std::string label_of(StrengthKind kind);
/// Stands for the strength of a test without one, beside which its largest stress may be told.
inline constexpr const char* did_not_fail = "did not fail";

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

/// A row of the history, and what stands beside the stress of the load curve there; SI.
struct CurveRow {
    std::size_t row = 0;
    double stress = 0;
    double load = 0;            ///< N per metre of thickness
    double strain = 0;          ///< platen approach over height since the start of the test
    double tensile_cracks = 0;  ///< contacts (points ÷ 2) by then, as the history of the run counts them
    double shear_cracks = 0;
};

/// Strengths are positive; SI. Empty: the test does not measure it.
struct Strength {
    /// As a laboratory reports it (`find_strength`): σ1, 2 F/(π t D) (Eq 18), in bending the nominal stress; empty for a test
    /// that did not fail.
    std::optional<double> strength;
    CurveRow peak;                        ///< that of `LoadCurve::peak`
    CurveRow largest;                     ///< that of the largest stress
    bool largest_is_peak = false;         ///< see `has_fallen`
    std::string peak_kind;                ///< see `peak_kind`
    std::optional<double> first_yield;    ///< see `first_yield`
    std::optional<FirstPeak> first_peak;  ///< uniaxial, triaxial
    /// Stress where the platen strain first reaches `strain_marks`, before or after the peak; empty if the test ended earlier.
    std::array<std::optional<double>, 3> stress_at_marks;

    /// Its strength of a kind. Of tests that have no residual one, as tension, Brazilian tests and bending, the strength.
    [[nodiscard]] std::optional<double> reported(StrengthKind kind = StrengthKind::first_peak) const;
    /// True if that is a peak: the stress fell behind it.
    [[nodiscard]] bool has_peak(StrengthKind kind = StrengthKind::first_peak) const {
        return kind == StrengthKind::largest ? largest_is_peak : strength.has_value();
    }
    /// The row of the strength of a kind.
    [[nodiscard]] const CurveRow& at(StrengthKind kind) const { return kind == StrengthKind::largest ? largest : peak; }
};

/// Axial strains at which the stress is reported: strengths of tests that harden are compared at equal strain.
inline constexpr std::array<double, 3> strain_marks{0.01, 0.02, 0.03};

Strength measure_strength(const RunData& run, const LoadCurve& curve);
/// \throws InputError if the run has no usable curve
inline Strength measure_strength(const RunData& run) { return measure_strength(run, load_curve(run)); }

/// The treatment of a run stopped at the strain limit whose largest stress is no peak: a fit through such values depends on the
/// strain limit that was chosen.
enum class StrainLimitRuns { refuse, accept };
/// True of such a run.
/// \param what requires the largest stress to be a peak, with an article: "an envelope"
/// \throws InputError if it is none and not accepted without one: stopped at the strain limit unless accepted, stopped otherwise
///         always
bool stopped_at_strain_limit(const RunData& run, const Strength& strength, StrainLimitRuns strain_limit_runs,
                             const std::string& what);

}  // namespace graincrack
