// Fits a power law of strength against grain size, and compares its exponent with theory and, for its rock, with the paper.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/measure/strength.hpp"
#include "post/run/load_curve.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// The power law strength = coefficient · (dp/1 mm)^exponent of the mean edge dp.
struct PowerLaw {
    Estimate exponent;
    double coefficient = 0;  ///< strength at a mean edge of 1 mm, Pa
    Line logarithms;         ///< line through ln(edge/mm) and ln(strength/Pa)
    /// The mean strength at an edge (m) with its 95 % interval, Pa.
    [[nodiscard]] Estimate strength_at(double edge) const;
};
/// Fits a straight line to logarithms, which assumes equal relative errors. Each run counts once, so a size is weighted by its
/// number of seeds. Empty unless there are two different edges. \param edge m \param strength Pa
std::optional<PowerLaw> fit_power_law(const std::vector<double>& edge, const std::vector<double>& strength);

/// Exponent of σt ∝ dp^½ at fixed contact parameters (paper, Eq 44).
inline constexpr double theory_exponent = 0.5;
/// Exponent of σt of Augig granite in the paper (Fig 10).
inline constexpr double paper_exponent = 0.39;

/// Runs of one test at one confining pressure.
struct SizeSeries {
    std::string test;
    double confining_pressure = 0;      ///< Pa
    std::vector<double> edge;           ///< m
    std::vector<double> strength;       ///< Pa
    std::vector<std::string> left_out;  ///< runs without a strength: their names and the reason
    std::size_t at_strain_limit = 0;    ///< runs stopped at the strain limit, whose largest stress replaces a peak
    double contact_zone_length = 0;     ///< length (9π/32) Ẽ Gf/tc² of the process zone, m
    bool of_paper = false;              ///< true for the rock of the paper
    /// The exponent for comparison; empty for another rock or test than the paper's.
    [[nodiscard]] std::optional<double> exponent_of_paper() const {
        return of_paper && test == "brazilian" ? std::optional(paper_exponent) : std::nullopt;
    }
};
/// Least ratio of edges of different sizes. Mean edges of seeds of one size differ by up to a percent; a scatter of strengths of
/// 4 % over this ratio is an exponent of 0.2, half of a typical size effect. Chosen by this estimate.
inline constexpr double min_edge_ratio = 1.2;
/// Sorts runs into series; those without a strength are left out. \throws InputError for runs of different materials or of
/// unknown mean edge, for a series of one size, and as `strength_for_fit`
std::vector<SizeSeries> collect_sizes(const std::vector<RunData>& runs, const EnvelopeOptions& options);

/// Writes one row per series. \param diagnostics gets a line for each run that was left out, and one if the largest stress of
/// some replaces a peak
void write_size_effect_table(std::ostream& out, const std::vector<RunData>& runs, TableFormat format,
                             const EnvelopeOptions& options, std::ostream& diagnostics);

}  // namespace graincrack
