#include "post/envelope.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "post/same_material.hpp"
#include "post/strength.hpp"
#include "share/error.hpp"
#include "share/mohr_coulomb.hpp"

namespace graincrack {

namespace {

const std::vector<std::string> columns{"runs",
                                       "capped_runs",
                                       "cohesion_MPa",
                                       "cohesion_low_MPa",
                                       "cohesion_high_MPa",
                                       "friction_angle_deg",
                                       "friction_angle_low_deg",
                                       "friction_angle_high_deg",
                                       "r_squared",
                                       "hoek_brown_sigma_ci_MPa",
                                       "hoek_brown_sigma_ci_low_MPa",
                                       "hoek_brown_sigma_ci_high_MPa",
                                       "hoek_brown_mi",
                                       "hoek_brown_mi_low",
                                       "hoek_brown_mi_high"};

/// Variances of intercept and slope of a straight line, from the scatter about it.
struct LineErrors {
    double intercept_variance = 0;
    double slope_variance = 0;
    double covariance = 0;
};

LineErrors line_errors(std::span<const double> x, std::span<const double> y, double intercept, double slope) {
    const double n = static_cast<double>(x.size());
    double mean = 0;
    for (double value : x) mean += value / n;
    double spread = 0;
    double scatter = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        spread += (x[i] - mean) * (x[i] - mean);
        scatter += std::pow(y[i] - intercept - slope * x[i], 2);
    }
    const double variance = scatter / (n - 2);
    return {variance * (1 / n + mean * mean / spread), variance / spread, -variance * mean / spread};
}

double friction_angle_of(double slope) { return slope > 0 ? std::asin((slope - 1) / (slope + 1)) : -std::numbers::pi / 2; }

/// \throws InputError if the runs cannot stand in one envelope
void require_comparable(const RunData& run, const RunData& first, CappedRuns capped_runs) {
    require_same_material(run, first, "an envelope");
    const auto refuse = [&](const std::string& what) {
        throw InputError(run.name + ": differs from " + first.name + " in " + what +
                         "; an envelope needs tests that differ in confining pressure and seed only");
    };
    if (run.header.plane != first.header.plane) refuse("the plane condition");
    if (capped_runs == CappedRuns::accept && run.header.max_strain != first.header.max_strain) refuse("the strain cap");
}

RunData read_compression_test(const std::string& path) {
    RunData run = read_run_data(path);
    if (!is_compression(run.header)) {
        throw InputError(run.name + ": a " + run.header.test + " test; an envelope takes uniaxial and triaxial runs");
    }
    return run;
}

/// Whether the run ended by the strain cap. \throws InputError if it has no peak and may not stand here
bool is_capped(const RunData& run, const Strength& strength, CappedRuns capped_runs) {
    if (strength.peak_kind == "drop") return false;
    if (strength.peak_kind != "cap") {
        throw InputError(run.name + ": was stopped (" + run.header.stop_reason +
                         ") before a peak; an envelope needs runs that fell behind their peak");
    }
    if (capped_runs == CappedRuns::refuse) {
        throw InputError(
            fmt::format("{}: ended by the strain cap ({:.3g} %) without a peak, its largest stress is no strength; "
                        "run it further (--max-strain), or take it as it is with --capped accept",
                        run.name, 100 * run.header.max_strain));
    }
    return true;
}

void append(std::vector<Cell>& row, const Estimate& estimate, double factor) {
    const auto in_unit = [factor](double value) { return value * factor; };
    row.emplace_back(in_unit(estimate.value));
    row.push_back(estimate.low ? Cell(in_unit(*estimate.low)) : Cell());
    row.push_back(estimate.high ? Cell(in_unit(*estimate.high)) : Cell());
}

}  // namespace

Envelope fit_envelope(std::span<const double> confining, std::span<const double> strength) {
    const MohrCoulomb line = fit_mohr_coulomb(confining, strength);
    Envelope envelope;
    envelope.cohesion.value = line.cohesion;
    envelope.friction_angle.value = line.friction_angle;
    envelope.r_squared = line.r_squared;
    envelope.hoek_brown = fit_hoek_brown(confining, strength);
    const int freedom = static_cast<int>(confining.size()) - 2;
    if (freedom < 1 || !(line.slope > 0)) return envelope;

    const double t = student_t_95(freedom);
    const LineErrors errors = line_errors(confining, strength, line.intercept, line.slope);
    const double half_slope = t * std::sqrt(errors.slope_variance);
    envelope.friction_angle.low = friction_angle_of(line.slope - half_slope);
    envelope.friction_angle.high = friction_angle_of(line.slope + half_slope);
    const double by_intercept = 1 / (2 * std::sqrt(line.slope));  // dC/da
    const double by_slope = -line.cohesion / (2 * line.slope);    // dC/db
    const double variance = by_intercept * by_intercept * errors.intercept_variance +
                            2 * by_intercept * by_slope * errors.covariance + by_slope * by_slope * errors.slope_variance;
    const double half_cohesion = t * std::sqrt(std::max(variance, 0.0));
    envelope.cohesion.low = line.cohesion - half_cohesion;
    envelope.cohesion.high = line.cohesion + half_cohesion;
    return envelope;
}

void write_envelope_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, CappedRuns capped_runs,
                          std::ostream& notes) {
    std::vector<double> confining;
    std::vector<double> strength;
    std::int64_t capped = 0;
    std::optional<RunData> first;
    for (const std::string& path : runs) {
        RunData run = read_compression_test(path);
        if (first) require_comparable(run, *first, capped_runs);
        const Strength measured = measure_strength(run);
        if (is_capped(run, measured, capped_runs)) ++capped;
        confining.push_back(run.header.confining_pressure);
        strength.push_back(*measured.peak_compressive_stress);
        if (!first) first = std::move(run);
    }
    if (capped > 0) {
        fmt::print(
            notes,
            "graincrack-post: envelope: {} of {} runs ended by the strain cap; their largest stress stands for a peak, so C "
            "and phi depend on where the tests were told to end\n",
            capped, runs.size());
    }
    const Envelope envelope = fit_envelope(confining, strength);
    constexpr double mega = 1e-6;
    constexpr double degrees = 180 / std::numbers::pi;
    std::vector<Cell> row{static_cast<std::int64_t>(runs.size()), capped};
    append(row, envelope.cohesion, mega);
    append(row, envelope.friction_angle, degrees);
    row.emplace_back(envelope.r_squared);
    if (envelope.hoek_brown) {
        append(row, envelope.hoek_brown->sigma_ci, mega);
        append(row, envelope.hoek_brown->mi, 1);
    }
    row.resize(columns.size());
    TableWriter(out, columns, format).row(row);
}

}  // namespace graincrack
