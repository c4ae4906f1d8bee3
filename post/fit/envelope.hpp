// Failure envelopes of a set of tests: Mohr–Coulomb and Hoek–Brown with 95 % intervals, beside the tensile strengths.
#pragma once

#include <iosfwd>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "post/fit/mohr_coulomb.hpp"
#include "post/measure/strength.hpp"
#include "post/options/command.hpp"
#include "post/run/load_curve.hpp"
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

/// Mohr–Coulomb line and Hoek–Brown curve through compressive strengths.
struct Envelope {
    MohrCoulomb line;         ///< σ1 = a + b σ3
    Estimate cohesion;        ///< C = a/(2√b), Pa
    Estimate friction_angle;  ///< sin φ = (b − 1)/(b + 1), rad
    std::optional<HoekBrown> hoek_brown;
    /// Tensile strength that the line has at σ1 = 0: a/b = 2C cos φ/(1 + sin φ), Pa.
    [[nodiscard]] double tensile_strength() const { return line.intercept / line.slope; }
    /// C and φ have intervals.
    [[nodiscard]] bool is_determined() const { return friction_angle.low.has_value(); }
};
/// An estimate that has an interval; empty without one: so few tests do not determine it.
inline std::optional<Estimate> determined(const std::optional<Estimate>& e) { return e && e->low ? e : std::nullopt; }
/// "not determined by 2 tests", in the place of such a value.
std::string not_determined(std::size_t tests);

/// Fits both envelopes. The interval of φ is that of the slope b, through which it is monotone; the interval of C is
/// linearised (C and φ come from the same line, so their errors are not independent). Both are empty with two tests, and where
/// the interval of b reaches zero: these do not determine them.
///
/// \param confining σ3, Pa \param strength peak σ1, Pa; equally long
/// \throws InputError unless there are strengths at two or more confining pressures
Envelope fit_envelope(std::span<const double> confining, std::span<const double> strength);

/// Which runs belong to an envelope, and which stress of them.
struct EnvelopeOptions {
    StrainLimitRuns strain_limit_runs = StrainLimitRuns::refuse;
    StrengthKind strength = StrengthKind::first_peak;  ///< of compression tests; that of others is the largest stress
};

/// The strengths of a set of runs of one material, sorted by test. Pa.
struct EnvelopeTests {
    struct Test {
        double confining = 0;
        double strength = 0;
        std::int64_t seed = 0;
    };
    StrengthKind kind = StrengthKind::largest;
    std::vector<Test> compression;
    std::size_t compression_runs = 0;    ///< also those left out
    std::vector<std::string> left_out;   ///< runs without a strength of this kind: their names and the reason
    std::vector<double> brazilian;       ///< tensile strengths by 2Fmax/(π t D)
    std::vector<double> direct_tension;  ///< tensile strengths
    std::size_t at_strain_limit = 0;     ///< runs whose largest stress stands for a peak
    [[nodiscard]] std::vector<double> confining() const;
    [[nodiscard]] std::set<double> pressures() const;  ///< each once
    [[nodiscard]] std::vector<double> strength() const;
};

/// Sorts runs by test. Runs without a strength are left out, unless the largest stress of compression tests is the strength.
/// \throws InputError for a run without a peak where the largest stress is the strength: one stopped at the strain limit, unless
///         accepted, or stopped otherwise; for one that differs from the first in law, rock or contact parameters, or in the
///         plane condition from the other compression tests: one envelope is the envelope of one material; if runs were left out
///         and the others have fewer than two confining pressures
EnvelopeTests collect_envelope_tests(const std::vector<RunData>& runs, const EnvelopeOptions& options);

/// The strength of a run for a fit. \param what needs it, with an article \param left_out gets the name of a run without one and
/// the reason \param at_strain_limit counts runs whose largest stress stands for a peak \throws InputError as
/// `stopped_at_strain_limit` where the largest stress is the strength
std::optional<double> strength_for_fit(const RunData& run, const Strength& strength, const EnvelopeOptions& options,
                                       const std::string& what, std::vector<std::string>& left_out, std::size_t& at_strain_limit);

/// A line for each run that was left out. \param command whose fit it is
void print_left_out(std::ostream& diagnostics, const std::string& command, const std::vector<std::string>& left_out);

/// Each seed with tests at all pressures of the set gives C and φ of its own; samples over these seeds. Empty with fewer than two
/// such seeds.
struct SeedEnvelopes {
    std::size_t seeds = 0;
    Sample cohesion;
    Sample friction_angle;
};
std::optional<SeedEnvelopes> fit_seed_envelopes(const EnvelopeTests& tests);

/// Options --capped and --strength: which runs an envelope has, and which stress of them.
void add_envelope_options(OptionSet set, EnvelopeOptions& options);
}  // namespace graincrack
