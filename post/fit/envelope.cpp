#include "post/fit/envelope.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "post/run/comparability.hpp"
#include "post/run/test_label.hpp"
#include "post/statistics/nonlinear_fit.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

/// Stresses over the largest strength, so that σci and mi have similar size for the solver.
struct Data {
    double scale = 1;
    std::vector<double> confining;
    std::vector<double> strength;
};

std::vector<double> scaled(std::span<const double> values, double factor) {
    std::vector<double> out(values.begin(), values.end());
    for (double& value : out) value *= factor;
    return out;
}

/// σ1 of the criterion. The radicand is at least a small positive value, so that the slope stays finite for extreme parameters.
double envelope(double sigma_ci, double mi, double confining) {
    return confining + std::sqrt(std::max(sigma_ci * (sigma_ci + mi * confining), 1e-12));
}

/// Parameters of the straight line (σ1 − σ3)² = σci² + mi σci σ3 in σ3, which are exact for exact data.
std::vector<double> first_guess(const Data& data) {
    std::vector<double> squares(data.confining.size());
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = std::pow(data.strength[i] - data.confining[i], 2);
    const std::optional<Line> line = fit_line(data.confining, squares);
    const double smallest = *std::ranges::min_element(squares);
    const double sigma_ci = std::sqrt(line->intercept > 0.01 * smallest ? line->intercept : 0.1 * smallest);
    return {sigma_ci, line->slope / sigma_ci};
}

Estimate times(Estimate e, double scale) {
    e.value *= scale;
    for (auto* end : {&e.low, &e.high}) {
        if (*end) **end *= scale;
    }
    return e;
}

std::optional<HoekBrown> fit(const Data& data) {
    const auto residuals = [&](std::span<const double> x, std::span<double> f) {
        for (std::size_t i = 0; i < f.size(); ++i) f[i] = envelope(x[0], x[1], data.confining[i]) - data.strength[i];
    };
    const std::optional<NonlinearFit> found = fit_nonlinear(residuals, first_guess(data), data.strength.size());
    if (!found || !(found->parameters[0] > 1e-5)) return std::nullopt;
    return HoekBrown{times(found->estimate(0), data.scale), found->estimate(1)};
}

/// Variance of C = a/(2√b), linearised.
double cohesion_variance(const Line& line, double cohesion) {
    const double by_intercept = 1 / (2 * std::sqrt(line.slope));  // dC/da
    const double by_slope = -cohesion / (2 * line.slope);         // dC/db
    return by_intercept * by_intercept * line.intercept_variance + 2 * by_intercept * by_slope * line.covariance +
           by_slope * by_slope * line.slope_variance;
}

/// Checks that two compression tests belong to one envelope. \throws InputError if not
void require_comparable(const RunData& run, const RunData& first, const EnvelopeOptions& options) {
    const auto refuse = [&](const std::string& what) {
        throw InputError(run.name + ": differs from " + first.name + " in " + what +
                         "; compression tests of an envelope differ in confining pressure and seed only");
    };
    const std::string found = differences(
        run, first, {SettingGroup::test, SettingGroup::pressure, SettingGroup::loading, SettingGroup::rate, SettingGroup::end});
    if (!found.empty()) refuse(found);
    if (options.strength == StrengthKind::largest && options.strain_limit_runs == StrainLimitRuns::accept &&
        run.header.max_strain != first.header.max_strain) {
        refuse("the strain limit");
    }
}

/// The reason why a run has no strength of a kind.
std::string reason_left_out(const RunData& run, const Strength& strength) {
    if (!is_compression(run.header)) return fmt::format("{}: {}", run.name, did_not_fail);
    if (!strength.first_peak) {
        return fmt::format("{}: {}, the stress never falls by {:.0f} % below a maximum before it exceeds it", run.name,
                           did_not_fail, 100 * peak_fall);
    }
    if (strength.first_peak->residual) {
        return fmt::format(
            "{}: no residual strength, its stress {:.1f} to {:.1f} % strain beyond the first peak is above it ({:.4g} MPa "
            "against {:.4g})",
            run.name, 100 * residual_strains[0], 100 * residual_strains[1], 1e-6 * *strength.first_peak->residual,
            1e-6 * strength.first_peak->stress);
    }
    return fmt::format(
        "{}: no residual strength, it ends before {:.1f} % strain beyond its first peak (run it further: --peak-drop "
        "none)",
        run.name, 100 * residual_strains[1]);
}

/// Checks the runs after others were left out. \throws InputError if they have fewer than two confining pressures
void require_two_pressures(const EnvelopeTests& tests) {
    if (tests.left_out.empty() || tests.pressures().size() > 1) return;
    throw InputError(
        fmt::format("{}; {} of {} compression runs have this strength; an envelope needs it at two or more "
                    "confining pressures",
                    tests.left_out.front(), tests.compression.size(), tests.compression_runs));
}

/// The tests of each seed, for seeds with tests at all pressures.
std::vector<EnvelopeTests> whole_seeds(const EnvelopeTests& tests) {
    std::map<std::int64_t, EnvelopeTests> by_seed;
    for (const auto& test : tests.compression) by_seed[test.seed].compression.push_back(test);
    std::vector<EnvelopeTests> whole;
    for (const auto& [seed, own] : by_seed) {
        if (own.pressures() == tests.pressures()) whole.push_back(own);
    }
    return whole;
}

}  // namespace

double HoekBrown::strength(double confining) const {
    const double square = sigma_ci.value * (sigma_ci.value + mi.value * confining);
    return square >= 0 ? confining + std::sqrt(square) : std::numeric_limits<double>::quiet_NaN();
}

double HoekBrown::tensile_strength() const { return sigma_ci.value * (std::sqrt(mi.value * mi.value + 4) - mi.value) / 2; }

std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength) {
    const bool two = std::ranges::any_of(confining, [&](double c) { return c != confining[0]; });
    const double scale = two ? *std::ranges::max_element(strength) : 0;
    if (!(scale > 0)) return std::nullopt;
    return fit({scale, scaled(confining, 1 / scale), scaled(strength, 1 / scale)});
}

std::vector<double> EnvelopeTests::confining() const {
    std::vector<double> out;
    for (const Test& test : compression) out.push_back(test.confining);
    return out;
}

std::set<double> EnvelopeTests::pressures() const {
    const std::vector<double> all = confining();
    return {all.begin(), all.end()};
}

std::vector<double> EnvelopeTests::strength() const {
    std::vector<double> out;
    for (const Test& test : compression) out.push_back(test.strength);
    return out;
}

std::string not_determined(std::size_t tests) { return fmt::format("not determined by {} tests", tests); }

Envelope fit_envelope(std::span<const double> confining, std::span<const double> strength) {
    Envelope envelope;
    envelope.line = fit_mohr_coulomb(confining, strength);
    envelope.cohesion.value = envelope.line.cohesion;
    envelope.friction_angle.value = envelope.line.friction_angle;
    envelope.hoek_brown = fit_hoek_brown(confining, strength);
    const Line& line = envelope.line;
    if (line.freedom < 1 || !(line.slope > 0)) return envelope;
    const double half_slope = student_t_95(line.freedom) * std::sqrt(line.slope_variance);
    if (!(line.slope > half_slope)) return envelope;  // the interval includes a falling line: φ and C are not determined
    envelope.friction_angle.low = friction_angle_of(line.slope - half_slope);
    envelope.friction_angle.high = friction_angle_of(line.slope + half_slope);
    envelope.cohesion = estimate(envelope.cohesion.value, cohesion_variance(line, envelope.cohesion.value), line.freedom);
    return envelope;
}

EnvelopeTests collect_envelope_tests(const std::vector<RunData>& runs, const EnvelopeOptions& options) {
    EnvelopeTests tests;
    tests.kind = options.strength;
    const RunData* first_compression = nullptr;
    require_comparable(runs, "an envelope");
    for (const RunData& run : runs) {
        if (run.header.loading() == Loading::program) {
            throw InputError(
                run.name +
                ": the confining pressure at the peak of a program is not known; an envelope needs uniaxial and triaxial tests");
        }
        if (!distinct_shape(run).empty()) {
            throw InputError(
                run.name + ": a test of a " + run.specimen.shape +
                " gives no point of an envelope; it needs uniaxial and triaxial tests, and takes direct tension and discs");
        }
        const Strength strength = measure_strength(run);
        if (is_compression(run.header)) {
            if (first_compression != nullptr) require_comparable(run, *first_compression, options);
            if (first_compression == nullptr) first_compression = &run;
            ++tests.compression_runs;
        }
        const auto stress = strength_for_fit(run, strength, options, "an envelope", tests.left_out, tests.at_strain_limit);
        if (!stress) continue;
        if (is_compression(run.header)) {
            tests.compression.push_back({run.header.confining_pressure, *stress, run.specimen.seed});
        } else {
            (run.header.loading() == Loading::splitting ? tests.brazilian : tests.direct_tension).push_back(*stress);
        }
    }
    require_two_pressures(tests);
    if (tests.compression.empty()) {
        throw InputError(runs.front().name +
                         ": no compression test among the runs; an envelope needs uniaxial and triaxial ones");
    }
    return tests;
}

std::optional<double> strength_for_fit(const RunData& run, const Strength& strength, const EnvelopeOptions& options,
                                       const std::string& what, std::vector<std::string>& left_out,
                                       std::size_t& at_strain_limit) {
    const StrengthKind kind = options.strength;
    if (kind == StrengthKind::largest && stopped_at_strain_limit(run, strength, options.strain_limit_runs, what)) {
        ++at_strain_limit;
    }
    const auto stress = strength.reported(kind);
    if (!stress) left_out.push_back(reason_left_out(run, strength));
    return stress;
}

void print_left_out(std::ostream& diagnostics, const std::string& command, const std::vector<std::string>& left_out) {
    for (const std::string& reason : left_out) {
        say(diagnostics, fmt::format("graincrack-post: {}: left out: {}", command, reason));
    }
}

std::optional<SeedEnvelopes> fit_seed_envelopes(const EnvelopeTests& tests) {
    std::vector<double> cohesion;
    std::vector<double> friction_angle;
    for (const EnvelopeTests& own : whole_seeds(tests)) {
        const MohrCoulomb line = fit_mohr_coulomb(own.confining(), own.strength());
        cohesion.push_back(line.cohesion);
        friction_angle.push_back(line.friction_angle);
    }
    if (cohesion.size() < 2) return std::nullopt;
    return SeedEnvelopes{cohesion.size(), sample(cohesion), sample(friction_angle)};
}

void add_envelope_options(OptionSet set, EnvelopeOptions& options) {
    add_choice<StrainLimitRuns>(set, "--capped", options.strain_limit_runs,
                                {{"refuse", StrainLimitRuns::refuse}, {"accept", StrainLimitRuns::accept}},
                                "with --strength largest, runs stopped at the strain limit: refuse them, or accept their largest "
                                "stress as a strength and "
                                "say so");
    add_choice<StrengthKind>(
        set, "--strength", options.strength,
        {{name_of(StrengthKind::first_peak), StrengthKind::first_peak},
         {name_of(StrengthKind::largest), StrengthKind::largest},
         {name_of(StrengthKind::residual), StrengthKind::residual}},
        "which stress of a compression test is taken as its strength: the first peak, as laboratories report it, "
        "the largest or the residual one; runs without it are left out");
}

}  // namespace graincrack
