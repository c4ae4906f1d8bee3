// Fits failure envelopes to a set of tests, Mohr–Coulomb and Hoek–Brown with 95 % intervals, and compares tensile strengths.
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

/// The criterion σ1 = σ3 + σci (mi σ3/σci + 1)^½ of intact rock (s = 1, a = ½; Hoek & Brown 1980).
struct HoekBrown {
    Estimate sigma_ci;  ///< Pa
    Estimate mi;
    /// σ1 at σ3, Pa; NaN beyond the tensile end of the envelope.
    [[nodiscard]] double strength(double confining) const;
    /// The σ3 at which σ1 = 0, positive: σci (√(mi² + 4) − mi)/2, Pa.
    [[nodiscard]] double tensile_strength() const;
};

/// Fits the criterion by non-linear least squares in σ1. Intervals follow from the covariance at the optimum and Student's t.
///
/// \param confining σ3, Pa \param strength peak σ1, Pa; of equal length
/// \return empty if there are fewer than two confining pressures, or if no σci > 0 fits
std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength);

/// Mohr–Coulomb line and Hoek–Brown curve through compressive strengths.
struct Envelope {
    MohrCoulomb line;         ///< σ1 = a + b σ3
    Estimate cohesion;        ///< C = a/(2√b), Pa
    Estimate friction_angle;  ///< sin φ = (b − 1)/(b + 1), rad
    std::optional<HoekBrown> hoek_brown;
    /// Tensile strength of the line at σ1 = 0: a/b = 2C cos φ/(1 + sin φ), Pa.
    [[nodiscard]] double tensile_strength() const { return line.intercept / line.slope; }
    /// True if C and φ have intervals.
    [[nodiscard]] bool is_determined() const { return friction_angle.low.has_value(); }
};
/// The estimate if it has an interval; otherwise empty, because too few tests do not determine it.
inline std::optional<Estimate> determined(const std::optional<Estimate>& e) { return e && e->low ? e : std::nullopt; }
/// The text "not determined by 2 tests", which replaces such a value.
std::string not_determined(std::size_t tests);

/// Fits both envelopes. The interval of φ is that of the slope b, of which φ is a monotone function. The interval of C is
/// linearised (the errors of a and b are correlated). Both are empty with two tests, and if the interval of b reaches zero.
///
/// \param confining σ3, Pa \param strength peak σ1, Pa; of equal length
/// \throws InputError unless there are strengths at two or more confining pressures
Envelope fit_envelope(std::span<const double> confining, std::span<const double> strength);

/// The choice of the runs of an envelope and of their strength.
struct EnvelopeOptions {
    StrainLimitRuns strain_limit_runs = StrainLimitRuns::refuse;
    StrengthKind strength = StrengthKind::first_peak;  ///< for compression tests; other tests have the largest stress
};

/// The strengths of a set of runs of one material, sorted by test, Pa.
struct EnvelopeTests {
    struct Test {
        double confining = 0;
        double strength = 0;
        std::int64_t seed = 0;
    };
    StrengthKind kind = StrengthKind::largest;
    std::vector<Test> compression;
    std::size_t compression_runs = 0;    ///< all of them, with those left out
    std::vector<std::string> left_out;   ///< runs without a strength of this kind: their names and the reason
    std::vector<double> brazilian;       ///< tensile strengths by 2Fmax/(π t D)
    std::vector<double> direct_tension;  ///< tensile strengths
    std::size_t at_strain_limit = 0;     ///< runs whose largest stress replaces a peak
    [[nodiscard]] std::vector<double> confining() const;
    [[nodiscard]] std::set<double> pressures() const;  ///< distinct confining pressures, Pa
    [[nodiscard]] std::vector<double> strength() const;
};

/// Sorts runs by test. Runs without a strength are left out, unless the largest stress is the strength of compression tests.
/// \throws InputError if the largest stress is the strength and a run has no peak, because it stopped at the strain limit without
/// `strain_limit_runs` accepting it, or for another reason; if a run differs from the first in law, rock or contact parameters,
/// or from other compression tests in the plane condition, because an envelope describes one material; if the runs that are not
/// left out have fewer than two confining pressures
EnvelopeTests collect_envelope_tests(const std::vector<RunData>& runs, const EnvelopeOptions& options);

/// Returns the strength of a run for a fit. \param what the fit, with an article \param left_out receives the name of a run
/// without a strength and the reason \param at_strain_limit counts runs whose largest stress replaces a peak \throws InputError
/// as `stopped_at_strain_limit` if the largest stress is the strength
std::optional<double> strength_for_fit(const RunData& run, const Strength& strength, const EnvelopeOptions& options,
                                       const std::string& what, std::vector<std::string>& left_out, std::size_t& at_strain_limit);

/// Prints a line for each run that was left out. \param command the command that makes the fit
void print_left_out(std::ostream& diagnostics, const std::string& command, const std::vector<std::string>& left_out);

/// Samples of C and φ over the seeds with tests at all pressures of the set, each fitted alone. Empty with fewer than two such
/// seeds.
struct SeedEnvelopes {
    std::size_t seeds = 0;
    Sample cohesion;
    Sample friction_angle;
};
std::optional<SeedEnvelopes> fit_seed_envelopes(const EnvelopeTests& tests);

/// Adds the options --capped and --strength, which select runs and strength.
void add_envelope_options(OptionSet set, EnvelopeOptions& options);
}  // namespace graincrack
